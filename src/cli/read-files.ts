import { readFileSync, statSync } from 'node:fs';
import { basename } from 'node:path';
import { parseScene } from '#scene/parse';
import { defaultScene, sceneLimits, type Scene } from '#scene/scene';
import type { InputEvent } from '#simulation/input';
import type { RunOptions } from './arguments';
import { parseInputs } from './input-file';

/** The files of a run, read and checked. */
export interface RunFiles {
  readonly scene: Scene;
  readonly files: Readonly<Record<string, string>>;
  readonly inputs: readonly InputEvent[];
}

/** A program or module longer than this is a mistake: the real board has 24 kB for all its files. */
const MAX_PROGRAM_BYTES = 1_000_000;

const MAX_INPUT_BYTES = 20_000_000; // 100,000 entries of 200 characters

/** The longest file name of the board's file system: micropython-microbit-v2, microbitfs. */
const MAX_NAME_CHARACTERS = 120;

/** Reads everything a run needs; a problem is one line or several, each naming the file. */
export function readRunFiles(options: RunOptions): RunFiles | { readonly problem: string } {
  try {
    const files: Record<string, string> = { 'main.py': readText(options.program, MAX_PROGRAM_BYTES) };
    for (const path of options.files) addFile(files, path);
    return {
      scene: options.scene === null ? defaultScene() : readScene(options.scene),
      files,
      inputs: options.input === null ? [] : readInputs(options.input),
    };
  } catch (error) {
    if (error instanceof BadFile) return { problem: error.problem };
    throw error;
  }
}

/** Ends the reading from any depth; only `readRunFiles` catches it. */
class BadFile {
  constructor(readonly problem: string) {}
}

function refuse(path: string, what: string): never {
  // eslint-disable-next-line @typescript-eslint/only-throw-error -- no stack is needed: it never leaves this file
  throw new BadFile(`${path}: ${what}`);
}

function addFile(files: Record<string, string>, path: string): void {
  const name = basename(path);
  if (name.length > MAX_NAME_CHARACTERS) {
    refuse(path, `the name has ${name.length} characters; the board takes ${MAX_NAME_CHARACTERS}.`);
  }
  if (Object.hasOwn(files, name)) refuse(path, `there is already a file "${name}" on the board.`);
  files[name] = readText(path, MAX_PROGRAM_BYTES);
}

function readScene(path: string): Scene {
  const parsed = parseScene(readText(path, sceneLimits.textCharacters * 4));
  if ('scene' in parsed) return parsed.scene;
  return refuse(path, parsed.problems.map((problem) => problem.message).join(`\n${path}: `));
}

function readInputs(path: string): readonly InputEvent[] {
  const parsed = parseInputs(readText(path, MAX_INPUT_BYTES));
  return 'inputs' in parsed ? parsed.inputs : refuse(path, parsed.problem);
}

function readText(path: string, maxBytes: number): string {
  let bytes: Uint8Array;
  try {
    const status = statSync(path);
    if (status.isDirectory()) refuse(path, 'is a folder. A file is wanted.');
    if (status.size > maxBytes)
      refuse(path, `has ${status.size} bytes; the limit is ${maxBytes}. Is it the right file?`);
    bytes = readFileSync(path);
  } catch (error) {
    if (error instanceof BadFile) throw error;
    return refuse(path, reasonOf(error));
  }
  try {
    return new TextDecoder('utf-8', { fatal: true }).decode(bytes);
  } catch {
    return refuse(path, 'is not text in UTF-8. Save it again as UTF-8.');
  }
}

/** Why a file could not be opened, in plain words. */
export function reasonOf(error: unknown): string {
  const code = error instanceof Error && 'code' in error ? error.code : undefined;
  switch (code) {
    case 'ENOENT':
      return 'there is no such file.';
    case 'EACCES':
      return 'may not be opened (permission denied).';
    case 'ENOTDIR':
    case 'EISDIR':
      return 'a folder and a file are mixed up in this path.';
    default:
      return error instanceof Error ? error.message : String(error);
  }
}

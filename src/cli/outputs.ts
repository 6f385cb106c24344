import { accessSync, closeSync, constants, existsSync, openSync, realpathSync, rmSync, statSync } from 'node:fs';
import { basename, dirname, join, resolve } from 'node:path';
import { formatOf } from '#intake/formats';
import { reasonOf } from './reason-of';

/** An output file of a command. */
export interface Output {
  /** The option for it as it is typed, such as `--csv`. */
  readonly option: string;
  /** `null`: the option was not given. */
  readonly path: string | null;
  /** Its folder is made where it is missing. */
  readonly isInNewFolder?: true;
}

/**
 * Finds the problem with files that a command is to write, `null` for none: no file may be one that it reads, under
 * any name or link, nor a program, nor the same as another one, and each can be written. Any number of outputs may go to
 * /dev/null and its like. It is asked before the work, whose results would be lost.
 *
 * @param reads files that the command reads; missing ones are ignored
 */
export function outputProblem(outputs: readonly Output[], reads: readonly string[], command: string): string | null {
  const asked = outputs.flatMap(({ path, ...output }) => (path === null ? [] : [{ ...output, path }]));
  const program = asked.find(({ path }) => formatOf(path) === 'program');
  if (program !== undefined) return `${program.option}: ${program.path} is called like a program. Choose another name.`;
  const problems = asked.map((output) => (output.isInNewFolder === true ? null : writeProblem(output)));
  const [unwritable] = problems.filter((problem) => problem !== null);
  if (unwritable !== undefined) return unwritable;
  const wanted = asked.filter(({ path }) => !existsSync(path) || statSync(path).isFile());
  const known = new Set(reads.filter((path) => existsSync(path)).flatMap(identities));
  for (const [place, { option, path }] of wanted.entries()) {
    const own = identities(path);
    if (own.some((one) => known.has(one))) return `${option}: ${path} is read by this ${command}. Choose another name.`;
    const other = wanted.slice(0, place).find((one) => identities(one.path).some((id) => own.includes(id)));
    if (other !== undefined)
      return `${other.option} and ${option}: ${path} can be only one of them. Choose another name.`;
  }
  return null;
}

/**
 * Tries whether a file can be written, and leaves everything as it was: an earlier file keeps its bytes, a new one is
 * removed again. A pipe is only asked for its rights, since its reader would take the try for the end.
 */
export function writeProblem({ option, path }: { readonly option: string; readonly path: string }): string | null {
  const folder = dirname(path);
  if (!existsSync(folder)) return `${option}: the folder ${folder} does not exist.`;
  try {
    const found = statSync(path, { throwIfNoEntry: false });
    if (found?.isDirectory() === true) return `${option}: ${path} is a folder. Name a file in it.`;
    if (found === undefined || found.isFile()) closeSync(openSync(path, 'a'));
    else accessSync(path, constants.W_OK);
    if (found === undefined) rmSync(realpathSync(path));
    return null;
  } catch (error) {
    return `${option}: ${path}: ${reasonOf(error)}`;
  }
}

/** True if two names mean one file, also through links. */
export function isSameFile(one: string, other: string): boolean {
  const own = identities(one);
  return identities(other).some((identity) => own.includes(identity));
}

/** Identities of a file, equal for two names of one file: its path behind links, and its number on its disk. */
function identities(path: string): readonly string[] {
  try {
    const { dev, ino } = statSync(path, { bigint: true });
    return [realpathSync(path), ...(ino === 0n ? [] : [`${dev}:${ino}`])];
  } catch {
    return [placeOf(path)];
  }
}

/** The future path of a file that does not exist yet. */
function placeOf(path: string): string {
  try {
    return join(realpathSync(dirname(resolve(path))), basename(path));
  } catch {
    return resolve(path);
  }
}

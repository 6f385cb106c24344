import { closeSync, existsSync, openSync, readSync, statSync } from 'node:fs';
import { basename } from 'node:path';
import type { MyRobot } from '#my-robot/my-robot';
import { parseProject } from '#project/file';
import { documentOf, textOf } from '#intake/file';
import { formatOf, limits } from '#intake/formats';
import { documentOfText, isOurs, TOURNAMENT } from '#intake/text';
import { MAIN, newWork } from '#project/project';
import { mapNoteText } from '#rescue-line/say';
import { scoredBy } from '#rescue-line/scored-by';
import { parseScene } from '#scene/parse';
import { defaultScene, type Scene } from '#scene/scene';
import type { InputEvent } from '#simulation/input';
import type { SetupAsked } from './run-arguments';
import { parseInputs } from '#simulation/input-file';
import {
  addressProblem,
  documentAt,
  isAddress,
  onlyProgram,
  shortened,
  workOfAddress,
  workOfHex,
  workOfJson,
  type Work,
} from './read-work';
import { reasonOf } from './reason-of';

/** The files of a run, read and checked. */
export interface RunFiles extends Work {
  readonly scene: Scene;
  /** Programs of the devices that `--device` adds, in their order: a program, or the first device's of a project. */
  readonly added: readonly Pick<Work, 'files' | 'settings'>[];
  readonly inputs: readonly InputEvent[];
  /** The measured robot that `--my-robot` lets drive; `null`: the project's, or the one of the type. */
  readonly myRobot: MyRobot | null;
}

const MAX_INPUT_BYTES = 20_000_000; // 100,000 entries of 200 characters

/** The longest file name of the board's file system: micropython-microbit-v2, microbitfs. */
const MAX_NAME_CHARACTERS = 120;

/** Reads everything a run needs; a problem is one line or several, each naming the file. */
export async function readRunFiles(options: SetupAsked): Promise<RunFiles | { readonly problem: string }> {
  return orProblemOf(async () => {
    const work = await readWork(options);
    const read =
      options.scene === null ? { scene: work.scene ?? defaultScene(), notes: [] } : await readScene(options.scene);
    return {
      ...work,
      scene: options.rules === null ? read.scene : scoredBy(read.scene, options.rules),
      notes: [...work.notes, ...read.notes],
      added: await Promise.all(options.devices.map(readWork)),
      inputs: options.input === null ? [] : readInputs(options.input),
      myRobot: options.myRobot === null ? null : readMyRobot(options.myRobot),
    };
  });
}

/** Reads something, or says what is wrong with a file. */
async function orProblemOf<T>(read: () => Promise<T>): Promise<T | { readonly problem: string }> {
  try {
    return await read();
  } catch (error) {
    if (error instanceof BadFile) return { problem: error.problem };
    throw error;
  }
}

/** The course behind a word of the command line, with what is to be said about it. */
export const readCourse = (word: string): Promise<CourseRead | { readonly problem: string }> =>
  orProblemOf(() => readScene(word));

/** The program behind a word of the command line: its first device's, of a project. */
export const filesOfWord = (word: string): Promise<Pick<Work, 'files'> | { readonly problem: string }> =>
  orProblemOf(() => readWork({ program: word, files: [] }));

/** The text of a file of at most this many bytes, or one line about the problem with it. */
export const readLimited = (path: string, maxBytes: number): { readonly text: string } | { readonly problem: string } =>
  orProblem(() => ({ text: readText(path, maxBytes) }));

/** The bytes of a file of at most so many, or one line about the problem with it. */
export const readBytesLimited = (
  path: string,
  maxBytes: number,
): { readonly bytes: Uint8Array } | { readonly problem: string } =>
  orProblem(() => ({ bytes: readBytes(path, maxBytes) }));

function orProblem<T>(read: () => T): T | { readonly problem: string } {
  try {
    return read();
  } catch (error) {
    if (error instanceof BadFile) return { problem: error.problem };
    throw error;
  }
}

/** A course, and what is to be said about it. */
interface CourseRead {
  readonly scene: Scene;
  readonly notes: readonly string[];
}

/** Ends the reading from any depth; only the functions above catch it. */
class BadFile {
  constructor(readonly problem: string) {}
}

function refuse(path: string, what: string): never {
  // eslint-disable-next-line @typescript-eslint/only-throw-error -- no stack is needed: it never leaves this file
  throw new BadFile(
    what
      .split('\n')
      .map((line) => `${path}: ${line}`)
      .join('\n'),
  );
}

/** The program or project, and further files on its board. */
async function readWork({ program, files: paths }: Pick<SetupAsked, 'program' | 'files'>): Promise<Work> {
  const read = isAddress(program) ? await workOfAddress(program) : await workOfFile(program);
  if ('problem' in read) return refuse(isAddress(program) ? shortened(program) : program, read.problem);
  const files = { ...read.files };
  for (const path of paths) addFile(files, path);
  return { ...read, files };
}

/** A file contains a project if its ending or its content says so; otherwise it is a program. */
async function workOfFile(path: string): Promise<Work | { readonly problem: string }> {
  if (formatOf(path) === 'hex') return workOfHex(await documentOf(path, readBytes(path, limits.hex), () => null));
  const isNamed = formatOf(path) === 'json';
  const text = readText(path, isNamed ? limits.json : limits.program);
  return isNamed || isOurs(text) ? workOfJson(text) : onlyProgram({ [MAIN]: text }, newWork);
}

const MAP = /"startTile"\s*:/;
const PROJECT = /^\s*\{\s*"format"\s*:\s*"parcours-project"/;

function addFile(files: Record<string, string>, path: string): void {
  const name = basename(path);
  if (name.length > MAX_NAME_CHARACTERS) {
    refuse(path, `the name has ${name.length} characters; the board takes ${MAX_NAME_CHARACTERS}.`);
  }
  if (Object.hasOwn(files, name)) refuse(path, `there is already a file "${name}" on the board.`);
  files[name] = readText(path, limits.program);
}

/** True if there is no file of this name (a folder is none): it can then only be the id of a ready course. */
export const isNoFile = (path: string): boolean => !existsSync(path) || statSync(path).isDirectory();

/** A course, that of a project or of a link, or a ready one by its id. */
async function readScene(word: string): Promise<CourseRead> {
  if (isAddress(word)) return { scene: await sceneOfAddress(word), notes: [] };
  if (isNoFile(word)) {
    const { noReadyCourse, readyCourse } = await import('./ready-courses');
    const ready = readyCourse(word);
    if (ready !== null) return { scene: ready, notes: [] };
    const more = existsSync(word) ? null : noReadyCourse(word);
    if (more !== null) return refuse(word, `there is no such file. ${more}`);
  }
  const text = readText(word, limits.json);
  const document = documentOfText(text, () => null);
  if (document.kind === 'project') return { scene: document.project.scene, notes: [] };
  if (document.kind === 'course')
    return { scene: document.scene, notes: document.mapNotes.map((note) => mapNoteText(note, 'en')) };
  if (document.kind === 'tournament') return refuse(word, TOURNAMENT.message);
  const parsed = parseScene(text);
  if ('scene' in parsed) return { scene: parsed.scene, notes: [] };
  // The problems inside a project or a map are reported, instead of "not a course".
  const { problems } = document.kind === 'unreadable' && (PROJECT.test(text) || MAP.test(text)) ? document : parsed;
  return refuse(word, problems.map((problem) => problem.message).join('\n'));
}

async function sceneOfAddress(address: string): Promise<Scene> {
  const document = await documentAt(address);
  if (document.kind === 'project') return document.project.scene;
  if (document.kind === 'course') return document.scene;
  const isProgram = document.kind === 'program';
  if (isProgram && document.scene !== null) return document.scene;
  return refuse(shortened(address), isProgram ? 'is a program without a course.' : addressProblem(document));
}

function readInputs(path: string): readonly InputEvent[] {
  const parsed = parseInputs(readText(path, MAX_INPUT_BYTES));
  return 'inputs' in parsed ? parsed.inputs : refuse(path, parsed.problem);
}

function readMyRobot(path: string): MyRobot {
  const parsed = parseProject(readText(path, limits.json));
  if ('problems' in parsed) return refuse(path, parsed.problems.map((problem) => problem.message).join('\n'));
  const { myRobot } = parsed.project.settings ?? {};
  return (
    myRobot ?? refuse(path, 'this project has no measured robot. Measure one on the page under "My robot" and save.')
  );
}

/** The bytes of a file, at most one more than these: the size of special files is unknown, and they may have no end. */
function readAtMost(path: string, maxBytes: number): Uint8Array {
  const file = openSync(path, 'r');
  try {
    const bytes = new Uint8Array(maxBytes + 1);
    let length = 0;
    for (let read = -1; read !== 0 && length < bytes.length; length += read)
      read = readSync(file, bytes, length, bytes.length - length, null);
    return bytes.subarray(0, length);
  } finally {
    closeSync(file);
  }
}

function readText(path: string, maxBytes: number): string {
  if (formatOf(path) === 'zip') refuse(path, 'is a zip. Unpack it and give one of its files; a whole class goes to parcours check.'); // prettier-ignore
  return textOf(readBytes(path, maxBytes)) ?? refuse(path, 'is not text in UTF-8. Save it again as UTF-8.');
}

function readBytes(path: string, maxBytes: number): Uint8Array {
  let bytes: Uint8Array;
  try {
    const status = statSync(path);
    if (status.isDirectory()) refuse(path, 'is a folder. A file is wanted.');
    if (status.size > maxBytes)
      refuse(path, `has ${status.size} bytes; the limit is ${maxBytes}. Is it the right file?`);
    bytes = readAtMost(path, maxBytes);
    if (bytes.length > maxBytes) refuse(path, `has more than ${maxBytes} bytes. Is it the right file?`);
  } catch (error) {
    if (error instanceof BadFile) throw error;
    return refuse(path, reasonOf(error));
  }
  return bytes;
}

import type { ReadyCourses } from '#project/link/link';
import { openJson } from '#project/open-json';
import { FILE_BYTES, MAIN, nameProblem, projectLimits, type Project, type SourceFile } from '#project/project';
import { isTapeFile } from '#tape/tape';
import { handedRun } from './handed-run';
import type { HandIn } from '#check/hand-in/hand-in';
import { isTextWithLinks, linksInFile } from './links';
import { handInOf, handInOfFiles } from '#check/hand-in/read-hand-in';
import { openLink } from './open-link';
import { unread, type Unread } from '#check/hand-in/unread';
import { Budget, chosenIn, HAND_IN_BYTES, lastOf, readBeside, type TreeFile } from './tree';
import { readZip } from './zip';

/** What a source holds: a hand-in, or why there is none. */
export type Content = { readonly handIn: HandIn } | { readonly problem: Unread };

/** Zips in zips that are opened. Chosen: a platform's around a pupil's around what was packed. */
const MOST_LEVELS = 3;

/** The largest file of a name that is opened, in bytes. */
export const mostBytes = (name: string): number => (/\.py$/i.test(name) ? FILE_BYTES : HAND_IN_BYTES);

/** The hand-in of a file: a program, a project, a text with a link to one, or a zip of one. Never throws. */
export async function handInOfBytes(
  name: string,
  bytes: Uint8Array,
  courses: ReadyCourses,
  packing: Packing = { budget: new Budget(), level: 0 },
): Promise<Content> {
  if (/\.zip$/i.test(name)) return handInOfZip(bytes, courses, packing);
  if (!/\.(json|py)$/i.test(name) && !isTextWithLinks(name)) return unread('kind');
  const text = textOf(bytes);
  if (text === null) return unread('not-text');
  if (/\.json$/i.test(name)) return handInOfJson(text);
  if (isTextWithLinks(name)) return handInOfText(name, text, courses);
  return handInOfPrograms([{ name: MAIN, text }]);
}

/** Where in zips a hand-in lies. */
interface Packing {
  readonly budget: Budget;
  /** How many zips are around it. */
  readonly level: number;
}

/** What is somebody's one link, such as a text that was typed into a learning platform. */
function handInOfText(name: string, text: string, courses: ReadyCourses): Content {
  const [first, second] = new Set(linksInFile(name, text).map(({ address }) => address));
  if (first === undefined) return unread('no-link');
  return second === undefined ? handInOfLink(first, courses) : unread('many-links');
}

/** The one hand-in that all these files are, at whatever depth its program lies. */
export async function handInOfTree(
  files: readonly TreeFile[],
  courses: ReadyCourses,
  { budget, level }: Packing = { budget: new Budget(), level: 0 },
): Promise<Content> {
  const chosen = chosenIn(files);
  if ('problem' in chosen) return chosen;
  const { program, beside } = chosen;
  const name = lastOf(program.path);
  const main = await budget.read(program, mostBytes(name));
  if ('problem' in main) return main;
  if (beside === undefined) return handInOfBytes(name, main.bytes, courses, { budget, level: level + 1 });
  const others = await readBeside(beside, budget);
  if ('problem' in others) return others;
  const read: SourceFile[] = [];
  for (const { name: own, bytes } of [{ name, bytes: main.bytes }, ...others]) {
    const text = textOf(bytes);
    // What the board could not hold does not belong to the program.
    if (text !== null && nameProblem(own, read) === null) read.push({ name: own, text });
    else if (own === MAIN) return unread('not-text');
  }
  return handInOfPrograms(read);
}

/** The hand-in of a link. */
export function handInOfLink(address: string, courses: ReadyCourses): Content {
  const opened = openLink(address, courses);
  if ('problem' in opened) return opened;
  if ('files' in opened) return handInOfPrograms(opened.files);
  return handInOfRun({ isEdited: false, ...opened });
}

function handInOfZip(bytes: Uint8Array, courses: ReadyCourses, packing: Packing): Content | Promise<Content> {
  if (packing.level >= MOST_LEVELS) return unread('no-main');
  const zip = readZip(bytes);
  return 'problem' in zip ? zip : handInOfTree(zip.entries, courses, packing);
}

function handInOfJson(text: string): Content {
  if (isTapeFile(text)) {
    const run = handedRun(text);
    return 'detail' in run ? unread(run.isNewer ? 'newer' : 'project', { detail: run.detail }) : handInOfRun(run);
  }
  const opened = openJson(text);
  if (opened.kind === 'problem')
    return unread(opened.problems[0]?.code === 'newer-version' ? 'newer' : 'project', { detail: opened.problem });
  return opened.kind === 'scene' ? unread('course') : handInOfProject(opened.project);
}

function handInOfProject(project: Project): Content {
  const read = handInOf(project);
  return 'problem' in read ? unread(read.isNewer ? 'newer' : 'project', { detail: read.problem }) : read;
}

function handInOfRun({ project, isEdited }: { readonly project: Project; readonly isEdited: boolean }): Content {
  const read = handInOfProject(project);
  return isEdited && 'handIn' in read ? { handIn: { ...read.handIn, isEdited } } : read;
}

function handInOfPrograms(files: readonly SourceFile[]): Content {
  if (files.length > projectLimits.files)
    return unread('many-files', { count: files.length, most: projectLimits.files });
  const large = files.find(({ text }) => text.length > FILE_BYTES);
  if (large !== undefined) return unread('large', { file: large.name, most: FILE_BYTES });
  return { handIn: handInOfFiles(files) };
}

function textOf(bytes: Uint8Array): string | null {
  try {
    return new TextDecoder('utf-8', { fatal: true }).decode(bytes);
  } catch {
    return null;
  }
}

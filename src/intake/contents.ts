import type { HandIn } from '#check/hand-in/hand-in';
import { handInOf, handInOfFiles } from '#check/hand-in/read-hand-in';
import { unread, type Unread } from '#check/hand-in/unread';
import type { ReadyCourses } from '#project/link/link';
import { FILE_BYTES, MAIN, nameProblem, projectLimits, type Project, type SourceFile } from '#project/project';
import { parseTape } from '#tape/file';
import { documentOfAddress } from './address';
import type { AddressDocument, Document, ProgramDocument, TextDocument } from './document';
import { documentOf, textOf } from './file';
import { isTextWithLinks, lastOf, mostBytes } from './formats';
import type { NamedLink } from './links';
import { projectOfRun } from './project-of-run';
import { SERIES } from './text';
import { Budget, chosenIn, readBeside, type TreeFile } from './tree';

/** The content of a source: a hand-in, or the reason why there is none. */
export type Content = { readonly handIn: HandIn } | { readonly problem: Unread };

/** Maximum depth of zips in zips. Chosen: a platform's around a pupil's around a packed program. */
const MOST_LEVELS = 3;

/** The place of a hand-in within zips. */
interface Packing {
  readonly budget: Budget;
  /** How many zips are around it. */
  readonly level: number;
}

const alone = (): Packing => ({ budget: new Budget(), level: 0 });

/** The hand-in of a file. Never rejects. */
export const handInOfBytes = async (
  name: string,
  bytes: Uint8Array,
  courses: ReadyCourses,
  packing = alone(),
): Promise<Content> => handInOfDocument(name, await documentOf(name, bytes, courses), courses, packing);

/** The hand-in in a file that was read: a program, a project, a run, a text with a link to one, or a zip of one. */
export async function handInOfDocument(
  name: string,
  document: Document,
  courses: ReadyCourses,
  packing = alone(),
): Promise<Content> {
  switch (document.kind) {
    case 'zip':
      return packing.level >= MOST_LEVELS ? unread('no-main') : handInOfTree(document.files, courses, packing);
    case 'links':
      return handInOfLinks(document.links, courses);
    case 'log':
      return unread(isTextWithLinks(name) ? 'no-link' : 'kind');
    case 'picture':
      return unread('kind');
    case 'hex':
      return handInOfPrograms(document.files);
    default:
      return handInOfWork(document);
  }
}

/** The one hand-in that all these files are, at whatever depth its program lies. */
export async function handInOfTree(
  files: readonly TreeFile[],
  courses: ReadyCourses,
  { budget, level } = alone(),
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
  const document = documentOfAddress(address, courses);
  if (document.kind !== 'recording') return handInOfWork(document);
  const run = handInOfRun(document.text);
  return 'problem' in run ? unread(run.problem.code === 'newer' ? 'newer-link' : 'link') : run;
}

/** The hand-in of a person's only link, such as a text that was typed into a learning platform. */
function handInOfLinks(links: readonly NamedLink[], courses: ReadyCourses): Content {
  const [first, second] = new Set(links.map(({ address }) => address));
  if (first === undefined) return unread('no-link');
  return second === undefined ? handInOfLink(first, courses) : unread('many-links');
}

function handInOfWork(document: ProgramDocument | TextDocument | AddressDocument): Content {
  switch (document.kind) {
    case 'program':
      return handInOfPrograms(document.files);
    case 'project':
      return handInOfProject(document.project);
    case 'recording':
      return handInOfRun(document.text);
    case 'course':
      return unread('course');
    case 'series':
      return { problem: SERIES.problem };
    case 'unreadable':
      return { problem: document.problem };
    default:
      return unread('no-work');
  }
}

function handInOfProject(project: Project): Content {
  const read = handInOf(project);
  return 'problem' in read ? unread(read.isNewer ? 'newer' : 'project', { detail: read.problem }) : read;
}

/** The hand-in of a recorded run: its project. The outcome of the run does not count: it is run anew. */
function handInOfRun(text: string): Content {
  const read = parseTape(text);
  if ('problem' in read) return unread(read.fault === 'newer' ? 'newer' : 'project', { detail: read.problem });
  const { setup } = read.tape;
  const made = projectOfRun(setup, setup.devices[0].name);
  if ('problems' in made) return unread('project', { detail: made.problems.map(({ message }) => message).join(' ') });
  const content = handInOfProject(made.project);
  const isEdited = read.changes.length > 0;
  return isEdited && 'handIn' in content ? { handIn: { ...content.handIn, isEdited } } : content;
}

/** The hand-in of program files; one alone is main.py, whatever its file is called. */
function handInOfPrograms(files: readonly SourceFile[]): Content {
  if (files.length > projectLimits.files)
    return unread('many-files', { count: files.length, most: projectLimits.files });
  const named = files.length === 1 ? files.map(({ text }) => ({ name: MAIN, text })) : files;
  const large = named.find(({ text }) => text.length > FILE_BYTES);
  if (large !== undefined) return unread('large', { file: large.name, most: FILE_BYTES });
  return { handIn: handInOfFiles(named) };
}

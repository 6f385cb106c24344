import type { HandIn } from '#check/hand-in/hand-in';
import { handInOf, handInOfFiles } from '#check/hand-in/read-hand-in';
import { unread, type Unread } from '#check/hand-in/unread';
import type { ReadyCourses } from '#project/link/link';
import { FILE_BYTES, MAIN, nameProblem, projectLimits, type Project, type SourceFile } from '#project/project';
import { parseTape } from '#tape/file';
import { documentOfAddress } from './address';
import type { AddressDocument, Document, ProgramDocument, TextDocument } from './document';
import { decoded, type Decoded } from './decode';
import { documentOf } from './file';
import { formatOf, isTextWithLinks, lastOf, mostBytes } from './formats';
import type { NamedLink } from './links';
import { projectOfRun } from './project-of-run';
import { SERIES, TOURNAMENT } from './text';
import { Budget, chosenIn, readBeside, type Chosen, type TreeFile } from './tree';

/** The content of a source: a hand-in, or the reason why there is none; then perhaps several, of which somebody chooses. */
export type Content = { readonly handIn: HandIn } | { readonly problem: Unread; readonly choices?: readonly Choice[] };

/** A file that may be the program of a hand-in. */
export interface Choice {
  /** Its path in the folder or zip. */
  readonly file: string;
  readonly handIn: HandIn;
}

/** Maximum number of files from which somebody chooses. Chosen: a row of buttons that is still read. */
const MOST_CHOICES = 12;

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
  packing = alone(),
): Promise<Content> {
  const chosen = chosenIn(files);
  if ('problem' in chosen) return chosen;
  return 'candidates' in chosen
    ? handInOfSeveral(chosen.candidates, courses, packing)
    : handInOfChosen(chosen, courses, packing);
}

/** The only one of several that is a hand-in; else all that are, for somebody to choose. */
async function handInOfSeveral(
  candidates: readonly Chosen[],
  courses: ReadyCourses,
  packing: Packing,
): Promise<Content> {
  const choices: Choice[] = [];
  let first: Content = unread('no-main');
  for (const chosen of candidates.slice(0, MOST_CHOICES)) {
    const { path } = chosen.program;
    const content = await handInOfChosen(chosen, courses, packing);
    if ('handIn' in content) choices.push({ file: path, handIn: content.handIn });
    else if (content.choices === undefined) first = chosen === candidates[0] ? content : first;
    else choices.push(...content.choices.map(({ file, handIn }) => ({ file: `${path}/${file}`, handIn })));
  }
  const [only, another] = choices;
  if (another === undefined) return only === undefined ? first : { handIn: only.handIn };
  const names = choices.map(({ file }) => file).join(', ');
  return { ...unread('several', { files: names + (candidates.length > MOST_CHOICES ? ', …' : '') }), choices };
}

/** The hand-in whose files are known. */
async function handInOfChosen(
  { program, beside }: Chosen,
  courses: ReadyCourses,
  { budget, level }: Packing,
): Promise<Content> {
  const name = beside === undefined ? lastOf(program.path) : MAIN;
  const main = await budget.read(program, mostBytes(name));
  if ('problem' in main) return main;
  if (beside === undefined) return handInOfBytes(name, main.bytes, courses, { budget, level: level + 1 });
  const others = await readBeside(beside, budget);
  if ('problem' in others) return others;
  const read: SourceFile[] = [];
  let coding: Decoded['coding'];
  for (const { name: own, bytes } of [{ name, bytes: main.bytes }, ...others]) {
    const text = decoded(bytes);
    const isData = formatOf(own) !== 'program' && text?.coding !== undefined;
    // What the board could not hold does not belong to the program.
    if (text !== null && !isData && nameProblem(own, read) === null) {
      read.push({ name: own, text: text.text });
      coding ??= text.coding;
    } else if (own === MAIN) return unread('not-text');
  }
  return handInOfPrograms(read, coding);
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
      return handInOfPrograms(document.files, document.coding);
    case 'project':
      return handInOfProject(document.project);
    case 'recording':
      return handInOfRun(document.text);
    case 'course':
      return unread('course');
    case 'series':
      return { problem: SERIES.problem };
    case 'tournament':
      return { problem: TOURNAMENT.problem };
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
function handInOfPrograms(files: readonly SourceFile[], coding?: Decoded['coding']): Content {
  if (files.length > projectLimits.files)
    return unread('many-files', { count: files.length, most: projectLimits.files });
  const named = files.length === 1 ? files.map(({ text }) => ({ name: MAIN, text })) : files;
  const large = named.find(({ text }) => text.length > FILE_BYTES);
  if (large !== undefined) return unread('large', { file: large.name, most: FILE_BYTES });
  return { handIn: { ...handInOfFiles(named), ...(coding !== undefined && { coding }) } };
}

import { basename } from 'node:path';
import type { AddressDocument, Document, ProgramDocument, RewrittenLine } from '#intake/document';
import { documentOf } from '#intake/file';
import { formatOf, limits } from '#intake/formats';
import { documentOfText, TOURNAMENT } from '#intake/text';
import { defaultProjectSettings, MAIN, newWork, type SourceFile } from '#project/project';
import { noteText } from '#project/webtigerpython/say';
import type { Note } from '#project/webtigerpython/note';
import { mapNoteText } from '#rescue-line/say';
import type { Linked } from '#project/webtigerpython/write-link';
import { withoutReload } from '../check/series-task';
import { unreadText } from '#check/report/say';
import type { ReadHex } from '#hex/hex';
import { unreadHex, whyEmpty } from '#intake/hex-document';
import { isNoFile, readBytesLimited, readLimited } from '../read-files';
import { deviceOf, documentAt, hexNotes, isAddress, shortened } from '../read-work';

/** Work that was read, whatever it came as. */
export interface Input {
  readonly kind: 'program' | 'project' | 'course' | 'hex';
  /** Without files: a course alone. */
  readonly work: Linked;
  /** Id of the ready course that it has; `null`: none. */
  readonly course: string | null;
  /** Sentences on what could not be taken over, or was changed. */
  readonly notes: readonly string[];
  /** How a hex was made, and for which boards; left out: it is none. */
  readonly hex?: Pick<ReadHex, 'made' | 'boards'>;
  /** Lines of the program that came otherwise; left out: none. */
  readonly rewritten?: readonly RewrittenLine[];
}

type Problem = { readonly problem: string };

/** Reads a file, an address, the text of a course or the id of a ready course; or one sentence on why it is none of these. */
export async function readInput(word: string): Promise<Input | Problem> {
  const input = await inputOfWord(word);
  if ('problem' in input) return { problem: `${shortened(word)}: ${input.problem}` };
  // A program alone is new work, as parcours run has it.
  const isNew = input.kind === 'program' && formatOf(word) === 'program' && !isAddress(word);
  const settings = { ...defaultProjectSettings, ...newWork };
  return isNew ? { ...input, work: { ...input.work, settings } } : input;
}

async function inputOfWord(word: string): Promise<Input | Problem> {
  if (formatOf(word) === 'hex' && !isAddress(word)) return inputOfHex(word);
  const read = await documentOfWord(word);
  return 'problem' in read && !('kind' in read) ? read : inputOf(read);
}

async function documentOfWord(word: string): Promise<Document | AddressDocument | Problem> {
  if (isAddress(word) || /^[?#]/.test(word)) return documentAt(word);
  if (word.trimStart().startsWith('{')) return documentOfText(word, await readyCourses());
  if (isNoFile(word)) {
    const isReady = (await readyCourses())(word) !== null;
    if (isReady) return { kind: 'ready', course: word, isWhole: true };
  }
  const file = readLimited(word, formatOf(word) === 'program' ? limits.program : limits.json);
  if ('problem' in file) return { problem: file.problem.replace(`${word}: `, '') };
  const text = file.text.trim();
  // Also a world alone, which is no link of a hand-in.
  if (formatOf(word) !== 'program' && isAddress(text) && !text.includes('\n')) return documentAt(text);
  const document = await documentOf(basename(word), new TextEncoder().encode(file.text), await readyCourses());
  if (document.kind !== 'links') return document;
  const [first, second] = new Set(document.links.map(({ address }) => address));
  return first === undefined || second !== undefined
    ? { problem: 'has several links. Give one of them.' }
    : documentAt(first);
}

const readyCourses = async () => (await import('../ready-courses')).readyCourse;

async function inputOf(document: Document | AddressDocument): Promise<Input | Problem> {
  switch (document.kind) {
    case 'program':
      return inputOfProgram(document);
    case 'project': {
      const { course, ...work } = document.project;
      const changed = 'The ready course that the link names has changed since the link was made.';
      return { kind: 'project', work, course, notes: document.isCourseChanged ? [changed] : [] };
    }
    case 'course':
      return { kind: 'course', work: { files: [], scene: document.scene, ...settingsFor(document.device) }, course: null, notes: [...said(document.notes), ...document.mapNotes.map((note) => mapNoteText(note, 'en'))] }; // prettier-ignore
    case 'ready':
      return inputOfReady(document.course, document.isWhole);
    case 'recording':
      return { problem: 'is a recorded run. Run it again with parcours replay.' };
    case 'tournament':
      return { problem: TOURNAMENT.message };
    case 'series':
    case 'series-link':
    case 'series-place':
      return { problem: 'is a series of tasks. Open it on the page, and save one of them.' };
    case 'unreadable':
      return { problem: document.message === '' ? NONE : withoutReload(document.message) };
    default:
      return { problem: NONE };
  }
}

const NONE = 'is no program (.py), no project, no course and no link to one of them.';

async function inputOfProgram({
  files,
  scene,
  device,
  course,
  notes,
  rewritten,
}: ProgramDocument): Promise<Input | Problem> {
  const ready = course === null ? null : (await readyCourses())(course);
  if (course !== null && ready === null) return { problem: `there is no ready course "${course}".` };
  const work: Linked = { files: withMain(files), scene: ready ?? scene, ...settingsFor(device) };
  return { kind: 'program', work, course, notes: said(notes), rewritten };
}

async function inputOfReady(id: string, isWhole: boolean): Promise<Input | Problem> {
  const { readyCourse, readyProject } = await import('../ready-courses');
  const [scene, project] = [readyCourse(id), isWhole ? readyProject(id) : null];
  if (scene === null) return { problem: `there is no ready course "${id}".` };
  if (project !== null) return { kind: 'project', work: project, course: id, notes: [] };
  return { kind: 'course', work: { files: [], scene }, course: id, notes: [] };
}

/** A hex, also one without a program that can be taken over: then a sentence tells what it is. */
async function inputOfHex(path: string): Promise<Input | Problem> {
  const file = readBytesLimited(path, limits.hex);
  if ('problem' in file) return { problem: file.problem.replace(`${path}: `, '') };
  const { openHex } = await import('#hex/open');
  const opened = openHex(new TextDecoder().decode(file.bytes));
  if ('problem' in opened) return { problem: unreadText(unreadHex(opened.problem), 'en') };
  const { hex, files, ours, unfit } = opened;
  const why = whyEmpty(opened);
  const notes = [...(why === null ? [] : [unreadText(why, 'en')]), ...hexNotes({ ours, unfit })];
  const settings = { ...defaultProjectSettings, ...newWork, ...deviceOf(hex.boards) };
  return { kind: 'hex', work: { files: withMain(files), scene: null, settings }, course: null, hex, notes };
}

/** A file alone is main.py, whatever it is called. */
const withMain = (files: readonly SourceFile[]): readonly SourceFile[] =>
  files.map(({ name, text }) => ({ name: files.length === 1 ? MAIN : name, text: text.replaceAll('\r\n', '\n') }));

const settingsFor = (device: string | null): Pick<Linked, 'settings'> =>
  device === null ? {} : { settings: { ...defaultProjectSettings, device } };

const said = (notes: readonly Note[]): readonly string[] => notes.map((note) => noteText(note, 'en'));

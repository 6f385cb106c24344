import type { HandIn } from '#check/hand-in/hand-in';
import { handInOf, handInOfFiles } from '#check/hand-in/read-hand-in';
import { openJson } from '#project/open-json';
import { FILE_BYTES, MAIN, nameProblem, projectLimits, type SourceFile } from '#project/project';
import { openAddress } from '../read-work';
import { isTextWithLinks, linksInFile } from './links';
import { readZip } from './zip';

/** What a source holds: a hand-in, or why there is none. */
export type Content = { readonly handIn: HandIn } | { readonly problem: string };

/** A file somewhere. */
export interface NamedBytes {
  readonly name: string;
  readonly bytes: Uint8Array;
}

/** Largest file that is opened. Chosen: more than the largest project. */
export const MOST_FILE_BYTES = 4 * projectLimits.textCharacters;

/** A link takes a moment to be opened. */
type Opened = Content | Promise<Content>;

/** The hand-in of a file: a program, a project, a text with a link to one, or a zip of one. Never throws. */
export function handInOfBytes(name: string, bytes: Uint8Array): Opened {
  if (/\.zip$/i.test(name)) return handInOfZip(bytes);
  const text = textOf(bytes);
  if (text === null) return { problem: 'is neither a program nor a project.' };
  if (/\.json$/i.test(name)) return handInOfJson(text);
  if (isTextWithLinks(name)) return handInOfText(name, text);
  if (!/\.py$/i.test(name)) return { problem: 'is neither a program (.py) nor a project (.json).' };
  return handInOfPrograms([{ name: MAIN, text }]);
}

/** What is somebody's one link, such as a text that was typed into a learning platform. */
function handInOfText(name: string, text: string): Opened {
  const [first, second] = new Set(linksInFile(name, text).map(({ address }) => address));
  if (first === undefined) return { problem: 'has no link in it.' };
  return second === undefined ? handInOfAddress(first) : { problem: 'has several links in it. A hand-in is one.' };
}

/** The hand-in of a folder: its main.py with the files beside it; without one its only program, project or text with a link. */
export function folderHandIn(files: readonly NamedBytes[]): Opened {
  const main = files.find(({ name }) => name === MAIN);
  if (main === undefined) {
    const programs = files.filter(({ name }) => /\.(py|json|zip)$/i.test(name));
    const likely = programs.length > 0 ? programs : files.filter(({ name }) => isTextWithLinks(name));
    const [only] = likely;
    if (only === undefined || likely.length > 1) return { problem: 'has no main.py.' };
    return handInOfBytes(only.name, only.bytes);
  }
  const read: SourceFile[] = [];
  for (const { name, bytes } of [main, ...files.filter((file) => file !== main)]) {
    const text = textOf(bytes);
    // What the board could not hold does not belong to the program.
    if (text !== null && nameProblem(name, read) === null) read.push({ name, text });
    else if (name === MAIN) return { problem: 'main.py is not text in UTF-8.' };
  }
  return handInOfPrograms(read);
}

/** The hand-in of a link. */
export async function handInOfAddress(address: string): Promise<Content> {
  const opened = await openAddress(address);
  if ('problem' in opened) return opened;
  return 'project' in opened ? handInOf(opened.project) : handInOfPrograms(opened.files);
}

function handInOfZip(bytes: Uint8Array): Opened {
  const zip = readZip(bytes);
  if ('problem' in zip) return zip;
  const files: NamedBytes[] = [];
  for (const entry of zip.entries) {
    const { path } = entry;
    if (path.includes('/') || /\.zip$/i.test(path)) continue;
    const file = entry.read(FILE_BYTES);
    if ('problem' in file) return { problem: `${path}: ${file.problem}` };
    files.push({ name: path, bytes: file.bytes });
  }
  return folderHandIn(files);
}

function handInOfJson(text: string): Content {
  const opened = openJson(text);
  if (opened.kind === 'problem') return { problem: opened.problem };
  return opened.kind === 'scene' ? { problem: 'is a course without a program.' } : handInOf(opened.project);
}

function handInOfPrograms(files: readonly SourceFile[]): Content {
  if (files.length > projectLimits.files)
    return { problem: `has ${files.length} files; the limit is ${projectLimits.files}.` };
  const large = files.find(({ text }) => text.length > FILE_BYTES);
  if (large !== undefined) return { problem: `${large.name} has more than ${FILE_BYTES} bytes.` };
  return { handIn: handInOfFiles(files) };
}

function textOf(bytes: Uint8Array): string | null {
  try {
    return new TextDecoder('utf-8', { fatal: true }).decode(bytes);
  } catch {
    return null;
  }
}

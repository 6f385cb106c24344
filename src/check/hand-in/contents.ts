import type { ReadyCourses } from '#project/link/link';
import { openJson } from '#project/open-json';
import { FILE_BYTES, MAIN, nameProblem, projectLimits, type Project, type SourceFile } from '#project/project';
import { isTapeFile } from '#tape/tape';
import { handedRun } from './handed-run';
import type { HandIn } from './hand-in';
import { isTextWithLinks, linksInFile } from './links';
import { handInOf, handInOfFiles } from './read-hand-in';
import { openLink } from './open-link';
import { unread, type Unread } from './unread';
import { belowFolders, readZip } from './zip';

/** What a source holds: a hand-in, or why there is none. */
export type Content = { readonly handIn: HandIn } | { readonly problem: Unread };

/** A file somewhere. */
export interface NamedBytes {
  readonly name: string;
  readonly bytes: Uint8Array;
}

/** Largest file that is opened. Chosen: more than the largest project. */
export const MOST_FILE_BYTES = 4 * projectLimits.textCharacters;

/** The hand-in of a file: a program, a project, a text with a link to one, or a zip of one. Never throws. */
export function handInOfBytes(name: string, bytes: Uint8Array, courses: ReadyCourses): Content {
  if (/\.zip$/i.test(name)) return handInOfZip(bytes, courses);
  if (!/\.(json|py)$/i.test(name) && !isTextWithLinks(name)) return unread('kind');
  const text = textOf(bytes);
  if (text === null) return unread('not-text');
  if (/\.json$/i.test(name)) return handInOfJson(text);
  if (isTextWithLinks(name)) return handInOfText(name, text, courses);
  return handInOfPrograms([{ name: MAIN, text }]);
}

/** What is somebody's one link, such as a text that was typed into a learning platform. */
function handInOfText(name: string, text: string, courses: ReadyCourses): Content {
  const [first, second] = new Set(linksInFile(name, text).map(({ address }) => address));
  if (first === undefined) return unread('no-link');
  return second === undefined ? handInOfLink(first, courses) : unread('many-links');
}

/** The hand-in of a folder: its main.py with the files beside it; without one its only program, project or text with a link. */
export function folderHandIn(files: readonly NamedBytes[], courses: ReadyCourses): Content {
  const main = files.find(({ name }) => name === MAIN);
  if (main === undefined) {
    const programs = files.filter(({ name }) => /\.(py|json|zip)$/i.test(name));
    const likely = programs.length > 0 ? programs : files.filter(({ name }) => isTextWithLinks(name));
    const [only] = likely;
    if (only === undefined || likely.length > 1) return unread('no-main');
    return handInOfBytes(only.name, only.bytes, courses);
  }
  const read: SourceFile[] = [];
  for (const { name, bytes } of [main, ...files.filter((file) => file !== main)]) {
    const text = textOf(bytes);
    // What the board could not hold does not belong to the program.
    if (text !== null && nameProblem(name, read) === null) read.push({ name, text });
    else if (name === MAIN) return unread('not-text');
  }
  return handInOfPrograms(read);
}

/** The hand-in of a link. */
export function handInOfLink(address: string, courses: ReadyCourses): Content {
  const opened = openLink(address, courses);
  if ('problem' in opened) return opened;
  return 'project' in opened ? handInOfProject(opened.project) : handInOfPrograms(opened.files);
}

function handInOfZip(bytes: Uint8Array, courses: ReadyCourses): Content {
  const zip = readZip(bytes);
  if ('problem' in zip) return zip;
  const files: NamedBytes[] = [];
  for (const entry of belowFolders(zip.entries)) {
    const { path } = entry;
    if (path.includes('/') || /\.zip$/i.test(path)) continue;
    const file = entry.read(FILE_BYTES);
    if ('problem' in file) return file;
    files.push({ name: path, bytes: file.bytes });
  }
  return folderHandIn(files, courses);
}

function handInOfJson(text: string): Content {
  if (isTapeFile(text)) {
    const run = handedRun(text);
    return 'detail' in run
      ? unread(run.isNewer ? 'newer' : 'project', { detail: run.detail })
      : handInOfProject(run.project);
  }
  const opened = openJson(text);
  if (opened.kind === 'problem')
    return unread(opened.problems[0]?.code === 'newer-version' ? 'newer' : 'project', { detail: opened.problem });
  return opened.kind === 'scene' ? unread('course') : handInOfProject(opened.project);
}

function handInOfProject(project: Project): Content {
  const read = handInOf(project);
  return 'problem' in read ? unread('project', { detail: read.problem }) : read;
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

import { unread } from '#check/hand-in/unread';
import type { ReadyCourses } from '#project/link/link';
import { decoded, type Decoded } from './decode';
import { unreadable, type Document } from './document';
import { formatOf, isTextWithLinks, isWork, lastOf, limits, mayBeLog, mostBytes, plainName, stemOf } from './formats';
import { hexDocument } from './hex-document';
import { linksInFile } from './links';
import { documentOfText, isOurs } from './text';
import { attachmentsIn, senderOf } from './mail';
import type { Bytes, TreeFile } from './tree';
import { readZip, type Zip } from './zip';

/** Reads the bytes of a file, by the ending of its name; our own files are known without one, too. Never rejects. */
export async function documentOf(path: string, bytes: Uint8Array, courses: ReadyCourses): Promise<Document> {
  return formatOf(path) === 'hex' ? hexDocument(bytes) : plainDocument(lastOf(path), bytes, courses);
}

function plainDocument(name: string, bytes: Uint8Array, courses: ReadyCourses): Document {
  const format = formatOf(name);
  if (format === 'picture') return { kind: 'picture' };
  if (format === 'zip') return zipDocument(readZip(bytes));
  if (isTextWithLinks(name)) return documentWithLinks(name, bytes);
  if (mayBeLog(name)) return { kind: 'log', bytes };
  const read = decoded(bytes);
  const isJson = format === 'json' || (format === 'other' && read !== null && isOurs(read.text));
  if (format === 'other' && !isJson) return unreadable(unread('kind').problem);
  if (read === null) return unreadable(unread('not-text').problem);
  return isJson ? documentOfText(read.text, courses) : programDocument(plainName(name), read);
}

/** Reads a text in which links may stand, which may be an e-mail with files, a program or a device's readings. */
function documentWithLinks(name: string, bytes: Uint8Array): Document {
  const [format, read] = [formatOf(name), decoded(bytes)];
  const text = read?.text ?? new TextDecoder().decode(bytes);
  const links = linksInFile(name, text);
  if (links.length > 0) return { kind: 'links', links };
  const attached = format === 'mail' ? filesInMail(text) : null;
  if (attached !== null) return attached;
  if (format === 'text' && read !== null && isProgram(text)) return programDocument(`${stemOf(name)}.py`, read);
  return mayBeLog(name) ? { kind: 'log', bytes } : unreadable(unread('no-link').problem);
}

/** True for a text with a line that only a program has: an import, or the head of a loop, a branch or a function. */
const isProgram = (text: string): boolean =>
  /^[ \t]*(from[ \t]+[\w.]+[ \t]+import[ \t]|import[ \t]+[\w.]+[ \t]*(,|;|#|\r?$)|(while|for|if|def)\b[^\n]*:[ \t]*(#.*)?\r?$)/m.test(
    text,
  );

const programDocument = (name: string, { text, coding }: Decoded): Document => ({
  ...{ kind: 'program', files: [{ name, text }], device: null, course: null, scene: null, notes: [], rewritten: [] },
  ...(coding !== undefined && { coding }),
});

/** The files of an e-mail; `null`: none of them is somebody's work. */
function filesInMail(source: string): Document | null {
  const files = attachmentsIn(source);
  return files.some(({ path }) => isWork(path)) ? { kind: 'zip', files, from: senderOf(source) } : null;
}

/** Reads a file of at most `most` bytes; left out: as many as its name allows (`mostBytes`). Never rejects. */
export async function openFile(file: TreeFile, courses: ReadyCourses, most?: number): Promise<Document> {
  const format = formatOf(file.path);
  if (format === 'picture') return { kind: 'picture' };
  const read = await bytesOf(file, most ?? mostBytes(file.path));
  if ('bytes' in read) return documentOf(file.path, read.bytes, courses);
  const isStrange = format === 'other' && read.problem.code === 'large';
  return unreadable(isStrange ? unread('kind').problem : read.problem);
}

/** Reads a file that was opened with others. Never rejects. */
export const documentIn = ({ file, zip }: Opened, courses: ReadyCourses, most?: number): Promise<Document> =>
  zip === null ? openFile(file, courses, most) : Promise.resolve(zipDocument(zip));

/** A file that is wanted as a device's readings, whatever it is called. Never rejects. */
export async function openLog(file: TreeFile): Promise<Document> {
  const read = await bytesOf(file, limits.log);
  return 'bytes' in read ? { kind: 'log', bytes: read.bytes } : unreadable(read.problem);
}

/** The bytes of a file, or why there are none. Never rejects. @param unpacked the most that is read of it, in bytes */
export async function bytesOf(file: TreeFile, most: number, unpacked = most): Promise<Bytes> {
  try {
    if (file.size > most) return unread('large', { file: lastOf(file.path), most });
    return await file.read(unpacked);
  } catch (error) {
    return unread('gone', { problem: error instanceof Error ? error.message : String(error) });
  }
}

/** A file that came with others. The list of a zip is read once: whoever looks into it takes it from here. */
export interface Opened {
  readonly file: TreeFile;
  /** `null`: it is no zip, or its turn comes later. */
  readonly zip: Zip | null;
}

/** Opens a file. Never rejects. @param most the largest zip that is read, in bytes */
export async function openGiven(file: TreeFile, most: number = limits.zip): Promise<Opened> {
  if (formatOf(file.path) !== 'zip') return { file, zip: null };
  const read = await bytesOf(file, most);
  return { file, zip: 'problem' in read ? read : readZip(read.bytes) };
}

const zipDocument = (zip: Zip): Document =>
  'problem' in zip ? unreadable(zip.problem) : { kind: 'zip', files: zip.entries };

/** A text in UTF-8; `null`: it is none. */
export function textOf(bytes: Uint8Array): string | null {
  try {
    return new TextDecoder('utf-8', { fatal: true }).decode(bytes);
  } catch {
    return null;
  }
}

import { readdirSync, readFileSync, statSync } from 'node:fs';
import { basename, join } from 'node:path';
import { reasonOf } from '../reason-of';
import { isAddress } from '../read-work';
import {
  folderHandIn,
  handInOfAddress,
  handInOfBytes,
  MOST_FILE_BYTES,
  type Content,
  type NamedBytes,
} from './contents';
import { isTextWithLinks, linksInFile, type NamedLink } from './links';
import { readZip, type ZipEntry } from './zip';

/** A hand-in that is to be read when its turn comes. */
export interface Source {
  /** Unlike the others. */
  readonly name: string;
  read(): Content | Promise<Content>;
}

/** Largest zip, and largest file of links. Chosen: fits in memory beside the runs. */
const MOST_ZIP_BYTES = 500_000_000;
const MOST_LIST_BYTES = 20_000_000;

/** What lies about in folders and is nobody's hand-in. */
const isLitter = (name: string): boolean => name.startsWith('.') || name === '__MACOSX' || name === '__pycache__';

/**
 * Finds the hand-ins behind the words of the command line, in their order, those of a folder by their names: project files
 * and programs, folders and zips of them, files of links, links.
 *
 * @returns or what is wrong: a path that does not exist
 */
export async function findHandIns(
  paths: readonly string[],
): Promise<{ readonly sources: readonly Source[] } | { readonly problem: string }> {
  const found: Source[] = [];
  for (const path of paths) {
    const here = isAddress(path) ? [await linkSource({ name: '', address: path }, 0)] : await sourcesAt(path);
    if ('problem' in here) return here;
    found.push(...here);
  }
  return { sources: withOwnNames(found) };
}

/** A link beside which nobody is named has the name that its pupil has typed, else its number. */
async function linkSource({ name, address }: NamedLink, place: number): Promise<Source> {
  const content = name === '' ? await handInOfAddress(address) : null;
  const alias = content !== null && 'handIn' in content ? content.handIn.said?.alias : undefined;
  return { name: name || alias || `link ${place + 1}`, read: () => handInOfAddress(address) };
}

async function sourcesAt(path: string): Promise<readonly Source[] | { readonly problem: string }> {
  try {
    const status = statSync(path);
    if (status.isDirectory()) return inFolder(path);
    if (/\.zip$/i.test(path)) return inZipFile(path, status.size);
    if (isTextWithLinks(path)) return await inList(path, status.size);
    return [fileSource(path)];
  } catch (error) {
    return { problem: `${path}: ${reasonOf(error)}` };
  }
}

/** Each file is a hand-in, each sub-folder one. */
function inFolder(path: string): readonly Source[] {
  const entries = readdirSync(path, { withFileTypes: true }).filter(({ name }) => !isLitter(name));
  return sortedBy(entries, ({ name }) => name).map((entry) => {
    const inside = join(path, entry.name);
    return statSync(inside).isDirectory() ? folderSource(inside) : fileSource(inside);
  });
}

const fileSource = (path: string): Source => ({
  name: handInName(basename(path)),
  read: () => {
    const read = readBytes(path);
    return 'problem' in read ? read : handInOfBytes(basename(path), read.bytes);
  },
});

const folderSource = (path: string): Source => ({
  name: basename(path),
  read: () => {
    const files: NamedBytes[] = [];
    for (const name of readdirSync(path).filter((one) => !isLitter(one))) {
      const inside = join(path, name);
      if (!statSync(inside).isFile()) continue;
      const read = readBytes(inside);
      if ('problem' in read) return { problem: `${name}: ${read.problem}` };
      files.push({ name, bytes: read.bytes });
    }
    return folderHandIn(sortedBy(files, ({ name }) => name));
  },
});

function readBytes(path: string): { readonly bytes: Uint8Array } | { readonly problem: string } {
  try {
    const status = statSync(path);
    if (!status.isFile()) return { problem: 'is no file.' };
    if (status.size > MOST_FILE_BYTES) return { problem: `has ${status.size} bytes; the limit is ${MOST_FILE_BYTES}.` };
    return { bytes: readFileSync(path) };
  } catch (error) {
    return { problem: reasonOf(error) };
  }
}

/** A zip as a whole that cannot be read is a hand-in that cannot be read. */
function inZipFile(path: string, size: number): readonly Source[] {
  const name = basename(path);
  if (size > MOST_ZIP_BYTES) return [brokenSource(name, `has ${size} bytes; the limit is ${MOST_ZIP_BYTES}.`)];
  const zip = readZip(readFileSync(path));
  return 'problem' in zip ? [brokenSource(name, zip.problem)] : inZip(zip.entries);
}

const brokenSource = (name: string, problem: string): Source => ({ name, read: () => ({ problem }) });

/** Like a folder; one that holds a single folder of hand-ins is that folder. */
function inZip(all: readonly ZipEntry[]): readonly Source[] {
  const entries = all.filter(({ path }) => !path.split('/').some(isLitter));
  const isBelow = entries.every(({ path }) => path.includes('/'));
  const [top] = new Set(entries.map(({ path }) => path.split('/')[0] ?? ''));
  const isOneFolder = isBelow && new Set(entries.map(({ path }) => path.split('/')[0])).size === 1;
  if (isOneFolder && top !== undefined && !entries.some(({ path }) => path === `${top}/main.py`))
    return inZip(entries.map((entry) => ({ ...entry, path: entry.path.slice(top.length + 1) })));
  const folders = new Map<string, ZipEntry[]>();
  for (const entry of entries) {
    const [first = ''] = entry.path.split('/');
    const key = entry.path.includes('/') ? `${first}/` : first;
    folders.set(key, [...(folders.get(key) ?? []), entry]);
  }
  return sortedBy([...folders], ([key]) => key).map(([key, inside]) => {
    const [entry] = inside;
    return key.endsWith('/') || entry === undefined ? zipFolder(key.slice(0, -1), inside) : zipFile(entry);
  });
}

const zipFile = (entry: ZipEntry): Source => ({
  name: handInName(entry.path),
  read: () => {
    const read = entry.read(MOST_FILE_BYTES);
    return 'problem' in read ? read : handInOfBytes(entry.path, read.bytes);
  },
});

const zipFolder = (name: string, entries: readonly ZipEntry[]): Source => ({
  name,
  read: () => {
    const files: NamedBytes[] = [];
    for (const entry of sortedBy(entries, ({ path }) => path)) {
      const inside = entry.path.slice(name.length + 1);
      if (inside.includes('/')) continue;
      const read = entry.read(MOST_FILE_BYTES);
      if ('problem' in read) return { problem: `${inside}: ${read.problem}` };
      files.push({ name: inside, bytes: read.bytes });
    }
    return folderHandIn(files);
  },
});

/** A text with links in it: each is a hand-in. */
async function inList(path: string, size: number): Promise<readonly Source[]> {
  const name = handInName(basename(path));
  if (size > MOST_LIST_BYTES) return [brokenSource(name, `has ${size} bytes; the limit is ${MOST_LIST_BYTES}.`)];
  const links = linksInFile(path, readFileSync(path, 'utf8'));
  if (links.length === 0) return [brokenSource(name, 'has no link in it.')];
  return Promise.all(links.map(linkSource));
}

/** `anna` for anna.py, anna.json and anna.parcours.json. */
const handInName = (file: string): string => file.replace(/(\.parcours)?\.[^.]*$/, '') || file;

/** Sorted the same everywhere: by the letters' numbers. */
const sortedBy = <T>(things: readonly T[], key: (thing: T) => string): readonly T[] =>
  things.toSorted((a, b) => (key(a) < key(b) ? -1 : key(a) > key(b) ? 1 : 0));

/** `anna`, `anna (2)`, … */
function withOwnNames(sources: readonly Source[]): readonly Source[] {
  const taken = new Set<string>();
  return sources.map((source) => {
    let { name } = source;
    for (let number = 2; taken.has(name); number += 1) name = `${source.name} (${number})`;
    taken.add(name);
    return { ...source, name };
  });
}

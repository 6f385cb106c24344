import type { ReadyCourses } from '#project/link/link';
import { MAIN } from '#project/project';
import { folderHandIn, handInOfBytes, handInOfLink, MOST_FILE_BYTES, type Content, type NamedBytes } from './contents';
import { isTextWithLinks, linksIn, linksInFile, type NamedLink } from './links';
import { unread, type Unread } from './unread';
import { belowFolders, isLitter, readZip, type ZipEntry } from './zip';

/** A hand-in that is to be read when its turn comes. */
export interface Source {
  /** Unlike the others, once they are together (`withOwnNames`). */
  readonly name: string;
  read(): Content | Promise<Content>;
}

type Bytes = { readonly bytes: Uint8Array } | { readonly problem: Unread };

/** A file in a folder or a zip. */
export interface TreeFile {
  /** With `/` between folders; one that ends with it stands for a folder that has perhaps no file. */
  readonly path: string;
  /** Its bytes; never more than so many. */
  read(maxBytes: number): Bytes | Promise<Bytes>;
}

/** Something that cannot be read. */
export const brokenSource = (name: string, problem: Unread): Source => ({ name, read: () => ({ problem }) });

/** A file: a program, a project, or a zip of one. */
export const fileSource = (file: TreeFile, courses: ReadyCourses): Source => {
  const name = lastOf(file.path);
  return {
    name: handInName(name),
    async read() {
      const read = await file.read(MOST_FILE_BYTES);
      return 'problem' in read ? read : handInOfBytes(name, read.bytes, courses);
    },
  };
};

/** Largest zip, and largest text with links, in bytes. */
export interface Most {
  readonly zip: number;
  readonly list: number;
}

/** The hand-ins of a file: those in a zip, those behind the links in a text, else the one that it is. */
export async function sourcesIn(file: TreeFile, most: Most, courses: ReadyCourses): Promise<readonly Source[]> {
  const name = lastOf(file.path);
  const isZip = /\.zip$/i.test(name);
  if (!isZip && !isTextWithLinks(name)) return [fileSource(file, courses)];
  const read = await file.read(isZip ? most.zip : most.list);
  const called = isZip ? name : handInName(name);
  if ('problem' in read) return [brokenSource(called, read.problem)];
  if (isZip) return zipSources(name, read.bytes, courses);
  const linked = listSources(new TextDecoder().decode(read.bytes), courses, name);
  return linked.length === 0 ? [brokenSource(called, unread('no-link').problem)] : linked;
}

/** The hand-ins in a folder: each file is one, each sub-folder is one. */
export function folderSources(all: readonly TreeFile[], courses: ReadyCourses): readonly Source[] {
  const folders = new Map<string, TreeFile[]>();
  for (const file of all) {
    if (file.path.split('/').some(isLitter)) continue;
    const [first = ''] = file.path.split('/');
    const key = file.path.includes('/') ? `${first}/` : first;
    folders.set(key, [...(folders.get(key) ?? []), file]);
  }
  return sortedBy([...folders], ([key]) => key).map(([key, inside]) => {
    const [file] = inside;
    return key.endsWith('/') || file === undefined
      ? folderSource(key.slice(0, -1), inside, courses)
      : fileSource(file, courses);
  });
}

/** One hand-in of all files in a folder. */
const folderSource = (name: string, inside: readonly TreeFile[], courses: ReadyCourses): Source => ({
  name,
  async read() {
    const files: NamedBytes[] = [];
    for (const file of sortedBy(inside, ({ path }) => path)) {
      const own = file.path.slice(name.length + 1);
      if (own === '' || own.includes('/')) continue;
      const read = await file.read(MOST_FILE_BYTES);
      if ('bytes' in read) files.push({ name: own, bytes: read.bytes });
      // A film beside the program is nobody's program.
      else if (/\.(json|py|zip)$/i.test(own) || isTextWithLinks(own)) return read;
    }
    return folderHandIn(files, courses);
  },
});

/** The hand-ins in a zip, like those in a folder; one that cannot be read is a hand-in that cannot be read. */
function zipSources(name: string, bytes: Uint8Array, courses: ReadyCourses): readonly Source[] {
  const zip = readZip(bytes);
  if ('problem' in zip) return [brokenSource(name, zip.problem)];
  const inside = folderSources(belowFolders(zip.entries, isHandIn), courses);
  return inside.length > 0 ? inside : [brokenSource(name, unread('no-main').problem)];
}

/** The folder of a hand-in says whose it is. */
const isHandIn = (entries: readonly ZipEntry[]): boolean => entries.some(({ path }) => path === MAIN);

/**
 * The hand-ins behind the links in a text, whatever stands around them. Those beside which nobody is named have the name
 * that their pupil has typed, else their number.
 *
 * @param file what the text is, by the ending of its file; left out: something that was pasted
 */
export function listSources(text: string, courses: ReadyCourses, file?: string): readonly Source[] {
  const links = file === undefined ? linksIn(text) : linksInFile(file, text);
  return links.map((link, place) => linkSource(link, place, courses));
}

/** A link. */
export function linkSource({ name, address }: NamedLink, place: number, courses: ReadyCourses): Source {
  const read = (): Content => handInOfLink(address, courses);
  const content = name === '' ? read() : null;
  const alias = content !== null && 'handIn' in content ? content.handIn.said?.alias : undefined;
  return { name: name || alias || `link ${place + 1}`, read };
}

/** What a source holds; what vanishes meanwhile is something that cannot be read. */
export async function contentOf(source: Source): Promise<Content> {
  try {
    return await source.read();
  } catch (error) {
    return unread('gone', { problem: error instanceof Error ? error.message : String(error) });
  }
}

const lastOf = (path: string): string => path.slice(path.lastIndexOf('/') + 1);

/** `anna` for anna.py, anna.json, anna.parcours.json and anna.run.json. */
const handInName = (file: string): string => file.replace(/(\.parcours|\.run)?\.[^.]*$/, '') || file;

/** Sorted the same everywhere: by the letters' numbers. */
const sortedBy = <T>(things: readonly T[], key: (thing: T) => string): readonly T[] =>
  things.toSorted((a, b) => (key(a) < key(b) ? -1 : key(a) > key(b) ? 1 : 0));

/** `anna`, `anna (2)`, …: of several with one name each gets its own. `taken`: names that others have already. */
export function withOwnNames(sources: readonly Source[], taken: Iterable<string> = []): readonly Source[] {
  const names = new Set(taken);
  return sources.map((source) => {
    let { name } = source;
    for (let number = 2; names.has(name); number += 1) name = `${source.name} (${number})`;
    names.add(name);
    return { ...source, name };
  });
}

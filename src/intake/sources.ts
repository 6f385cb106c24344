import { unseenShown } from '#core/unseen';
import type { ReadyCourses } from '#project/link/link';
import { MAIN, nameProblem } from '#project/project';
import { handInOfDocument, handInOfLink, handInOfTree, type Content } from './contents';
import { openFile, type Opened } from './file';
import { formatOf, isTextWithLinks, lastOf, limits, mostBytes, stemOf } from './formats';
import { linksIn, linksInFile, type NamedLink } from './links';
import { platformName } from '#check/hand-in/platform-name';
import { unread, type Unread } from '#check/hand-in/unread';
import { chosenIn, sortedBy, withoutLitter, type TreeFile } from './tree';
import { belowFolders, isLitter, type Zip } from './zip';

/** A hand-in that is to be read when its turn comes. */
export interface Source {
  /** Unlike the others, once they are together (`withOwnNames`). */
  readonly name: string;
  read(): Content | Promise<Content>;
}

/** Something that cannot be read. */
export const brokenSource = (name: string, problem: Unread): Source => ({ name, read: () => ({ problem }) });

/** A file: a program, a project, or a zip of one. */
export const fileSource = (file: TreeFile, courses: ReadyCourses): Source => {
  const name = lastOf(file.path);
  return {
    name: stemOf(name),
    async read() {
      return handInOfDocument(name, await openFile(file, courses, mostAlone(name)), courses);
    },
  };
};

/** The largest file that is one hand-in. */
const mostAlone = (path: string): number => Math.min(mostBytes(path), limits.handIn);

/** A single item that was given, such as a word of the command line or a chosen file. */
export interface Given {
  /** Its name without the ending. */
  readonly name: string;
  /** A folder or a zip: a single hand-in in it may be called anything. */
  readonly isTree: boolean;
  readonly sources: readonly Source[];
}

/** The hand-ins of a file: those in a zip, those behind the links in a text, else the one that it is. Never rejects. */
export async function givenFile({ file, zip }: Opened, courses: ReadyCourses, isAlone: boolean): Promise<Given> {
  const name = lastOf(file.path);
  if (isLitter(name)) return plainly([]);
  if (zip !== null) return givenZip(name, zip, courses, isAlone);
  if (!isTextWithLinks(name)) return plainly([fileSource(file, courses)]);
  const document = await openFile(file, courses);
  const from = document.kind === 'zip' ? document.from : undefined;
  if (document.kind !== 'links')
    return plainly([{ name: from || stemOf(name), read: () => handInOfDocument(name, document, courses) }]);
  return plainly(document.links.map((link, place) => linkSource(link, place, courses)));
}

/** Hand-ins that have names of their own. */
const plainly = (sources: readonly Source[]): Given => ({ name: '', isTree: false, sources });

/**
 * All hand-ins of what was given together. Beside other things, a folder or zip of one hand-in gives it its name, unless
 * that of the hand-in itself was given by a platform, or is a pupil's rather than that of the folder or zip.
 */
export const together = (all: readonly Given[]): readonly Source[] =>
  all.flatMap(({ name, isTree, sources }) => {
    const [only, another] = sources;
    const isWhose = isTree && all.length > 1 && only !== undefined && another === undefined;
    return isWhose && platformName(only.name) === null && !(isTry(name) && !isTry(only.name))
      ? [{ ...only, name }]
      : sources;
  });

/**
 * The hand-ins of a folder: its files and its folders, or those of the one folder that all of it lies in, if that is a class.
 *
 * @param isAlone nothing else is given: it may be a whole class
 */
export const givenFolder = (
  name: string,
  files: readonly TreeFile[],
  courses: ReadyCourses,
  isAlone: boolean,
): Given => ({
  ...{ name, isTree: true },
  sources: treeSources(name, files, { courses, isAlone, isWhole: (below) => !isClass(below) }),
});

/** True for several folders with a program in each, or several programs that are called like their pupils. */
const isClass = (files: readonly TreeFile[]): boolean =>
  !isHandIn(files) &&
  (foldersIn(files).filter((inside) => !('problem' in chosenIn(inside))).length > 1 ||
    (programsIn(files).length > 1 && !areTries(files)));

const programsIn = (files: readonly TreeFile[]): readonly TreeFile[] =>
  files.filter(({ path }) => !path.includes('/') && formatOf(path) === 'program');

/** True for programs that are called like programs, not like pupils: they are one pupil's tries. */
const areTries = (files: readonly TreeFile[]): boolean =>
  programsIn(files).length > 1 && programsIn(files).every(({ path }) => isTry(stemOf(path)));

/** True for a name as programs have, not pupils. */
const isTry = (name: string): boolean => name.length < LONG && TRY.test(name);

/** Chosen: longer names are not looked at. */
const LONG = 80;

/** Names that pupils give to their programs, in the four languages, or a letter, with whatever number. */
const TRY =
  /^(main|haupt|prog(ram(m|me|ma)?)?|projekt|project|projet|progetto|robot(er)?|rob[oô]t|versuch|try|essai|prova|test|aufgabe|abgabe|rendu|consegna|task|t[aâ]che|compito|l[oö]sung|solution|soluzione|code|neu|new|nouveau|nuovo|alt|old|final|fertig|kopie|copy|copie|copia|version|[a-z])?[\s_\-().\d]*(main|kopie|copy|copie|copia|final|neu|new|alt|old)?[\s_\-().\d]*$/i;

/** The way in which a folder or a zip is searched for hand-ins. */
interface Looking {
  readonly courses: ReadyCourses;
  readonly isAlone: boolean;
  /** True if the folder that contains everything is one hand-in; `below`: what lies in it. */
  readonly isWhole: (below: readonly TreeFile[]) => boolean;
}

/** A file that a platform has given the name of its pupil lies in a folder with that name, if others of the same pupil do. */
function inPupilsFolders(files: readonly TreeFile[]): readonly TreeFile[] {
  const parts = files.map(({ path }) => (path.includes('/') ? null : platformName(path)));
  const counts = new Map<string, number>();
  for (const part of parts) if (part !== null) counts.set(part.before, (counts.get(part.before) ?? 0) + 1);
  return files.map((file, place) => {
    const part = parts[place] ?? null;
    const isOne = part === null || part.file === '' || (counts.get(part.before) ?? 0) < 2;
    return isOne ? file : { ...file, path: `${part.before}/${part.file}` };
  });
}

/**
 * The hand-ins in a folder or a zip. With main.py at its top it is one, and called like it; else each file is one, and each
 * folder, below the folders that all of it lies in. A whole class may have somebody's main.py among the others'.
 */
function treeSources(
  name: string,
  all: readonly TreeFile[],
  { courses, isAlone, isWhole }: Looking,
): readonly Source[] {
  const files = inPupilsFolders(
    belowFolders(withoutLitter(all), (below, top) => platformName(top) !== null || areTries(below) || isWhole(below)),
  );
  if (isHandIn(files) && !(isAlone && hasOthers(files))) return [{ name, read: () => handInOfTree(files, courses) }];
  return sortedBy([...byTop(files)], ([key]) => key).flatMap(([key, inside]) =>
    key.endsWith('/')
      ? [folderSource(key.slice(0, -1), inside, courses)]
      : inside.map((file) => fileSource(file, courses)),
  );
}

/** True if there are others' programs beside main.py: in several folders, or with names like `main (1).py`. */
const hasOthers = (files: readonly TreeFile[]): boolean =>
  foldersIn(files).filter((inside) => inside.some(({ path }) => lastOf(path) === MAIN)).length > 1 ||
  files.some(({ path }) => !path.includes('/') && formatOf(path) === 'program' && nameProblem(path, []) !== null);

const foldersIn = (files: readonly TreeFile[]): readonly (readonly TreeFile[])[] =>
  [...byTop(files)].flatMap(([key, inside]) => (key.endsWith('/') ? [inside] : []));

/** The files at the top by their names, and those of each folder by its name with `/`. */
function byTop(files: readonly TreeFile[]): ReadonlyMap<string, readonly TreeFile[]> {
  const tops = new Map<string, TreeFile[]>();
  for (const file of files) {
    const [first = ''] = file.path.split('/', 1);
    const key = file.path.includes('/') ? `${first}/` : first;
    const inside = tops.get(key);
    if (inside === undefined) tops.set(key, [file]);
    else inside.push(file);
  }
  return tops;
}

/** One hand-in of all files in a folder. */
function folderSource(name: string, inside: readonly TreeFile[], courses: ReadyCourses): Source {
  const files = inside.map((file) => ({ ...file, path: file.path.slice(name.length + 1) }));
  return { name, read: () => handInOfTree(files, courses) };
}

/** The hand-ins in a zip, like those in a folder; one that cannot be read is a hand-in that cannot be read. */
function givenZip(file: string, zip: Zip, courses: ReadyCourses, isAlone: boolean): Given {
  const broken = (problem: Unread): Given => plainly([brokenSource(file, problem)]);
  if ('problem' in zip) return broken(zip.problem);
  // What is too large alone is refused alone, and a film is never unpacked.
  const wanted = zip.entries.filter(({ path, size }) => isOpened(path) && size <= mostAlone(path));
  if (wanted.reduce((sum, { size }) => sum + size, 0) > limits.classInZip)
    return broken(unread('zip-much', { most: limits.classInZip }).problem);
  const name = stemOf(file);
  const sources = treeSources(name, zip.entries, {
    courses,
    isAlone,
    isWhole: (below) => isHandIn(below) && !hasOthers(below),
  });
  return sources.length > 0 ? { name, isTree: true, sources } : broken(unread('no-main').problem);
}

const isOpened = (path: string): boolean => !['picture', 'sheet', 'other'].includes(formatOf(path));

/** True if main.py lies at the top: the folder is one hand-in, and its name says whose. */
const isHandIn = (files: readonly TreeFile[]): boolean => files.some(({ path }) => path === MAIN);

/**
 * The hand-ins behind the links in a text, whatever stands around them. A link without a name beside it has the name
 * that its pupil has typed, else its number.
 *
 * @param file what the text is, by the ending of its file; left out: something that was pasted
 */
export function listSources(text: string, courses: ReadyCourses, file?: string): readonly Source[] {
  const links = file === undefined ? linksIn(text) : linksInFile(file, text);
  return links.map((link, place) => linkSource(link, place, courses));
}

/** The hand-in behind a link. Without a name it has the alias in its project, else its number, `place + 1`. */
export function linkSource({ name, address }: NamedLink, place: number, courses: ReadyCourses): Source {
  const read = (): Content => handInOfLink(address, courses);
  const content = name === '' ? read() : null;
  const alias = content !== null && 'handIn' in content ? content.handIn.said?.alias : undefined;
  return { name: name || alias || `link ${place + 1}`, read };
}

/** Reads a source; one that vanishes meanwhile cannot be read. */
export async function contentOf(source: Source): Promise<Content> {
  try {
    return await source.read();
  } catch (error) {
    return unread('gone', { problem: error instanceof Error ? error.message : String(error) });
  }
}

/** Sources with names of their own: `anna`, `anna (2)`, …; no two only look alike. `taken`: names in use already. */
export function withOwnNames(sources: readonly Source[], taken: Iterable<string> = []): readonly Source[] {
  const names = new Set(taken);
  return sources.map((source) => {
    const own = unseenShown(source.name.normalize('NFC'));
    let name = own;
    for (let number = 2; names.has(name); number += 1) name = `${own} (${number})`;
    names.add(name);
    return { ...source, name };
  });
}

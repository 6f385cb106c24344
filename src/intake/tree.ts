import { FILE_BYTES, MAIN, nameProblem, projectLimits } from '#project/project';
import { formatOf, isTextWithLinks, lastOf, limits, plainName, type Format } from './formats';
import { unread, type Unread } from '#check/hand-in/unread';
import { isLitter } from './zip';

/** The bytes, or the reason why they cannot be read. */
export type Bytes = { readonly bytes: Uint8Array } | { readonly problem: Unread };

/** A file in a folder or a zip. */
export interface TreeFile {
  /** With `/` between folders; one that ends with it stands for a folder that has perhaps no file. */
  readonly path: string;
  /** In bytes, as its folder or zip says before anything is read. */
  readonly size: number;
  /** Its bytes; never more than so many. */
  read(maxBytes: number): Bytes | Promise<Bytes>;
}

/** The files of one hand-in, chosen by their names alone. */
export interface Chosen {
  /** The file that is opened first. */
  readonly program: TreeFile;
  /** The files on the board besides main.py; left out: the program is something else, such as a project. */
  readonly beside?: readonly TreeFile[];
}

/** Several files of one hand-in that may be its program. */
interface Several {
  readonly candidates: readonly Chosen[];
}

/** The formats of a hand-in without a main.py. */
const PROGRAMS: readonly Format[] = ['program', 'json', 'zip'];

/** The bytes that may still be unpacked of a hand-in. */
export class Budget {
  private left: number = limits.handIn;

  /** Reads a file, if there is still room for it. */
  async read(file: TreeFile, most: number): Promise<Bytes> {
    const allowed = Math.min(most, this.left);
    if (file.size > allowed) return unread('large', { file: lastOf(file.path), most: allowed });
    const read = await file.read(allowed);
    if ('bytes' in read) this.left -= read.bytes.length;
    return read;
  }
}

/** The folder of a file, with the `/` at its end; empty: at the top. */
const folderOf = (path: string): string => path.slice(0, path.lastIndexOf('/') + 1);

/** The files at any depth without those that operating systems leave (`isLitter`), by the names that they were meant to have. */
export const withoutLitter = <T extends { readonly path: string }>(all: readonly T[]): readonly T[] => {
  const kept = all.filter(({ path }) => !path.split('/').some(isLitter));
  const paths = new Set(kept.map(({ path }) => path));
  return kept.map((file) => {
    const path = plainName(file.path);
    return path === file.path || paths.has(path) ? file : { ...file, path };
  });
};

/**
 * The program of one hand-in: the main.py that lies above all others, with what lies beside it; without one the only
 * program, project, run or zip; without such the only hex, or the only text that may have a link.
 */
export function chosenIn(all: readonly TreeFile[]): Chosen | Several | { readonly problem: Unread } {
  const files = withoutLitter(all).filter(({ path }) => !path.endsWith('/'));
  const beside = (program: TreeFile): Chosen => {
    const folder = folderOf(program.path);
    return { program, beside: files.filter((file) => file !== program && folderOf(file.path) === folder) };
  };
  const mains = files.filter(({ path }) => lastOf(path) === MAIN);
  if (mains.length > 0) {
    const program = mains.reduce((top, one) => (folderOf(one.path).length < folderOf(top.path).length ? one : top));
    const folder = folderOf(program.path);
    return mains.every(({ path }) => path.startsWith(folder)) ? beside(program) : severalOf(mains, beside);
  }
  const programs = files.filter(({ path }) => PROGRAMS.includes(formatOf(path)));
  const hexes = files.filter(({ path }) => formatOf(path) === 'hex');
  const texts = files.filter(({ path }) => isTextWithLinks(path));
  // A board's file is often handed in beside the program that is in it.
  const likely = [programs, hexes].find((some) => some.length > 0) ?? texts;
  const [program, another] = likely;
  if (program === undefined) return unread('no-main');
  // Another program beside it may be a module of it.
  return another === undefined
    ? { program }
    : severalOf(likely, (one) => (formatOf(one.path) === 'program' ? beside(one) : { program: one }));
}

const severalOf = (files: readonly TreeFile[], chosen: (program: TreeFile) => Chosen): Several => ({
  candidates: sortedBy(files, ({ path }) => path).map(chosen),
});

/**
 * Reads what the board has beside a main.py. What it could not hold, such as a film or a picture, is left out. Too many
 * programs are refused before any is read, and one that is too large before it is.
 */
export async function readBeside(
  beside: readonly TreeFile[],
  budget: Budget,
): Promise<readonly { readonly name: string; readonly bytes: Uint8Array }[] | { readonly problem: Unread }> {
  const fitting = beside.filter(({ path }) => nameProblem(lastOf(path), []) === null);
  const [modules, others] = [fitting.filter(isModule), fitting.filter((file) => !isModule(file))];
  const count = modules.length + 1;
  if (count > projectLimits.files) return unread('many-files', { count, most: projectLimits.files });
  const found: { readonly name: string; readonly bytes: Uint8Array }[] = [];
  for (const file of modules) {
    const read = await budget.read(file, FILE_BYTES);
    if ('problem' in read) return read;
    found.push({ name: lastOf(file.path), bytes: read.bytes });
  }
  let left: number = limits.besideProgram;
  for (const file of others.toSorted((a, b) => a.size - b.size)) {
    if (file.size > Math.min(FILE_BYTES, left)) break;
    const read = await budget.read(file, Math.min(FILE_BYTES, left));
    if ('problem' in read) continue;
    left -= read.bytes.length;
    found.push({ name: lastOf(file.path), bytes: read.bytes });
  }
  return sortedBy(found, ({ name }) => name);
}

const isModule = ({ path }: TreeFile): boolean => formatOf(path) === 'program';

/** Sorted the same everywhere: by the letters' numbers. */
export const sortedBy = <T>(things: readonly T[], key: (thing: T) => string): readonly T[] =>
  things.toSorted((a, b) => (key(a) < key(b) ? -1 : key(a) > key(b) ? 1 : 0));

import type { Project } from '#project/project';

import { packedText, unpackProject } from './stored-project';

/** A piece of earlier work that was put aside for something else. */
export interface Previous {
  /** What the pupil sees: the course's name. */
  readonly name: string;
  /** When it was put aside, in ms since 1970. */
  readonly atMs: number;
  readonly project: Project;
  /** The file it was opened from, without its ending. */
  readonly file?: string | undefined;
}

/** How many pieces of earlier work are kept. */
export const PREVIOUS_KEPT = 5;

/** Everything a tab keeps: the open work and what was put aside. */
export interface Work {
  readonly project: Project;
  /** Name of the file that is shown. */
  readonly open: string;
  /** The file the project was opened from, without its ending. */
  readonly file?: string | undefined;
  /** Newest first. */
  readonly previous: readonly Previous[];
}

/** Puts `entry` aside, newest first; the same work is kept once, but of two files that say the same both stay. */
export function putAside(previous: readonly Previous[], entry: Previous): readonly Previous[] {
  const others = previous.filter(({ file, project }) => file !== entry.file || !isSameWork(project, entry.project));
  return [entry, ...others].slice(0, PREVIOUS_KEPT);
}

/** Two projects with the same files in the same course. */
export function isSameWork(one: Project, other: Project): boolean {
  return packedText(one) === packedText(other);
}

/** Work as text for the browser's storage. */
export function workToText(work: Work): string {
  return textOfWork(work, packedText(work.project), ({ project }) => packedText(project));
}

/** Stored work that says when it was saved, in ms since 1970: of two copies the newer one is opened. */
export const stamped = (text: string, savedMs: number): string => `{"savedMs":${String(savedMs)},${text.slice(1)}`;

/** When `stamped` work was saved; 0 for what an earlier version of the app stored. */
export const savedMsOf = (text: string | null): number => Number(/^\{"savedMs":(\d+),/.exec(text ?? '')?.[1] ?? 0);

/** The same list with other texts for the projects. */
export function textOfWork(work: Work, project: string, previousText: (previous: Previous) => string): string {
  const previous = work.previous.map((entry) => {
    const { name, atMs, file } = entry;
    return `{"name":${JSON.stringify(name)},"atMs":${String(atMs)},${fileText(file)}"project":${previousText(entry)}}`;
  });
  const open = JSON.stringify(work.open);
  return `{"version":1,"project":${project},"open":${open},${fileText(work.file)}"previous":[${previous.join(',')}]}`;
}
const fileText = (file: string | undefined): string => (file === undefined ? '' : `"file":${JSON.stringify(file)},`);
const fileOf = (file: unknown): Pick<Work, 'file'> => (typeof file === 'string' ? { file } : {});

/** Reads what `workToText` wrote; `null` for anything else, so that a broken store never stops the app. */
export function workFromText(text: string): Work | null {
  let value: unknown;
  try {
    value = JSON.parse(text);
  } catch {
    return null;
  }
  if (typeof value !== 'object' || value === null) return null;
  const read = value as { version?: unknown; project?: unknown; open?: unknown; file?: unknown; previous?: unknown }; // prettier-ignore
  const project = unpackProject(read.project);
  if (read.version !== 1 || project === null) return null;
  const open = project.files.find((file) => file.name === read.open)?.name ?? project.files[0]?.name;
  const previous = Array.isArray(read.previous)
    ? read.previous.map(readPrevious).filter((entry) => entry !== null)
    : [];
  return open === undefined ? null : { project, open, ...fileOf(read.file), previous };
}

function readPrevious(value: unknown): Previous | null {
  if (typeof value !== 'object' || value === null) return null;
  const { name, atMs, project, file } = value as { name?: unknown; atMs?: unknown; project?: unknown; file?: unknown }; // prettier-ignore
  const read = unpackProject(project);
  if (typeof name !== 'string' || typeof atMs !== 'number' || read === null) return null;
  return { name, atMs, ...fileOf(file), project: read };
}

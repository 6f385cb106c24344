import type { Project } from '#project/project';

import { packedText, unpackProject } from './stored-project';

/** A piece of earlier work that was put aside for something else. */
export interface Previous {
  /** What the pupil sees: the course's name. */
  readonly name: string;
  /** When it was put aside, in ms since 1970. */
  readonly atMs: number;
  readonly project: Project;
}

/** How many pieces of earlier work are kept. */
export const PREVIOUS_KEPT = 5;

/** Everything a tab keeps: the open work and what was put aside. */
export interface Work {
  readonly project: Project;
  /** Name of the file that is shown. */
  readonly open: string;
  /** Newest first. */
  readonly previous: readonly Previous[];
}

/** Puts `project` aside, newest first; the same work is kept once. */
export function putAside(
  previous: readonly Previous[],
  project: Project,
  name: string,
  atMs: number,
): readonly Previous[] {
  const others = previous.filter((entry) => !isSameWork(entry.project, project));
  return [{ name, atMs, project }, ...others].slice(0, PREVIOUS_KEPT);
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
    const { name, atMs } = entry;
    return `{"name":${JSON.stringify(name)},"atMs":${String(atMs)},"project":${previousText(entry)}}`;
  });
  return `{"version":1,"project":${project},"open":${JSON.stringify(work.open)},"previous":[${previous.join(',')}]}`;
}

/** Reads what `workToText` wrote; `null` for anything else, so that a broken store never stops the app. */
export function workFromText(text: string): Work | null {
  let value: unknown;
  try {
    value = JSON.parse(text);
  } catch {
    return null;
  }
  if (typeof value !== 'object' || value === null) return null;
  const read = value as { version?: unknown; project?: unknown; open?: unknown; previous?: unknown };
  const project = unpackProject(read.project);
  if (read.version !== 1 || project === null) return null;
  const open = project.files.find((file) => file.name === read.open)?.name ?? project.files[0]?.name;
  const previous = Array.isArray(read.previous)
    ? read.previous.map(readPrevious).filter((entry) => entry !== null)
    : [];
  return open === undefined ? null : { project, open, previous };
}

function readPrevious(value: unknown): Previous | null {
  if (typeof value !== 'object' || value === null) return null;
  const { name, atMs, project } = value as { name?: unknown; atMs?: unknown; project?: unknown };
  const read = unpackProject(project);
  return typeof name === 'string' && typeof atMs === 'number' && read !== null ? { name, atMs, project: read } : null;
}

import type { Project } from '#project/project';

import { packedText } from './stored-project';

/** A piece of earlier work that was put aside for something else. */
export interface Previous {
  /** The name that the pupil sees: the course's, after that of the file if there is one. */
  readonly name: string;
  /** Time when it was put aside, in ms since 1970. */
  readonly atMs: number;
  readonly project: Project;
  /** The file it was opened from, without its ending. */
  readonly file?: string | undefined;
  /** A tab that was closed has left it. */
  readonly isOfTab?: true;
}

/** A piece of earlier work that was deleted. */
export interface Deleted extends Previous {
  /** Time when it was deleted, in ms since 1970. */
  readonly deletedMs: number;
}

/** For so long deleted work can be brought back, in ms. */
export const DELETED_MS = 30 * 24 * 3600 * 1000; // chosen: a month of lessons

/** The most files of works that can be opened at once. Chosen: more than anybody means to. */
export const MOST_AT_ONCE = 5;

/** From this size of all works together on (characters) the page asks which may go. Chosen: half of what tablets surely have. */
export const CROWDED_CHARACTERS = 3_000_000; // some two thousand missions

/** Everything that a tab stores: the open work and what was put aside. */
export interface Work {
  readonly project: Project;
  /** Name of the file that is shown. */
  readonly open: string;
  /** The file the project was opened from, without its ending. */
  readonly file?: string | undefined;
  /** The open work has been handed in. */
  readonly isHandedIn?: true;
  /** Newest first. */
  readonly previous: readonly Previous[];
  /** Last deleted first; left out: nothing. */
  readonly deleted?: readonly Deleted[];
}

/** Puts `entry` aside, newest first; the same work is kept once, but of two files that say the same both stay. */
export function putAside(previous: readonly Previous[], entry: Previous): readonly Previous[] {
  const others = previous.filter(({ file, project }) => file !== entry.file || !isSameWork(project, entry.project));
  return [entry, ...others];
}

/** The size of all works, with those that were deleted and can come back, in characters. */
export const sizeOf = ({ project, previous, deleted = [] }: Work): number =>
  [project, ...[...previous, ...deleted].map((entry) => entry.project)].reduce(
    (sum, one) => sum + packedText(one).length,
    0,
  );

/** True if two projects are the same: files, course, hardware, task and hand-in. */
export function isSameWork(one: Project, other: Project): boolean {
  return packedText(one) === packedText(other);
}

/** Work as text for the browser's storage. */
export function workToText(work: Work): string {
  return textOfWork(work, packedText(work.project), ({ project }) => packedText(project));
}

/** Stored work with the time when it was saved, in ms since 1970: of two copies the newer one is opened. */
export const stamped = (text: string, savedMs: number): string => `{"savedMs":${String(savedMs)},${text.slice(1)}`;

/** The time when `stamped` work was saved; 0 for what an earlier version of the app stored. */
export const savedMsOf = (text: string | null): number => Number(/^\{"savedMs":(\d+),/.exec(text ?? '')?.[1] ?? 0);

/** Work as text for the browser's storage, with the given texts for its projects. */
export function textOfWork(work: Work, project: string, previousText: (previous: Previous) => string): string {
  const texts = (entries: readonly (Previous | Deleted)[]): string =>
    entries.map((entry) => `{${factsText(entry)}"project":${previousText(entry)}}`).join(',');
  const open = JSON.stringify(work.open);
  const handedIn = work.isHandedIn === true ? '"isHandedIn":true,' : '';
  const deleted = work.deleted === undefined ? '' : `,"deleted":[${texts(work.deleted)}]`;
  return `{"version":1,"project":${project},"open":${open},${fileText(work.file)}${handedIn}"previous":[${texts(work.previous)}]${deleted}}`;
}
/** All that is known of earlier work but what it consists of. */
const factsText = ({ project: _, ...facts }: Previous | Deleted): string => `${JSON.stringify(facts).slice(1, -1)},`;
const fileText = (file: string | undefined): string => (file === undefined ? '' : `"file":${JSON.stringify(file)},`);

import { draftOf } from '../task/read-task';
import { projectOfTask, withoutPart } from '../task/write-task';
import { noAbout, type TaskAbout } from '../task/about';
import type { Series } from '../series/series';
import { isSame } from '#core/same';
import type { Project } from '#project/project';

/** Something on a teacher's shelf. */
export type ShelfWork =
  { readonly kind: 'task'; readonly project: Project } | { readonly kind: 'series'; readonly series: Series };

/** The list of a shelf that a school hosts: its files lie beside it. */
export interface ShelfList {
  /** Its title; empty: none. */
  readonly title: string;
  readonly entries: readonly ShelfEntry[];
}

/** A task or a series in a list. */
export interface ShelfEntry {
  readonly name: string;
  /** Address of its file, seen from the list. */
  readonly file: string;
  /** A sentence on it, for the search; empty: none. */
  readonly text: string;
  readonly about: TaskAbout;
}

/** Limits of a list. Chosen: all that the teachers of a school make in years. */
export const shelfLimits = {
  entries: { min: 0, max: 2000 },
  titleCharacters: 120,
  nameCharacters: 120,
  fileCharacters: 1000,
  textCharacters: 300,
  /** Size of the whole file. */
  characters: 2_000_000,
} as const;

/** The details of a work; `null`: they cannot be read. */
export function aboutOf(work: ShelfWork): TaskAbout | null {
  if (work.kind === 'series') return work.series.about ?? noAbout;
  if (work.project.task === undefined) return noAbout;
  const read = draftOf(work.project);
  return 'task' in read ? (read.task.about ?? noAbout) : null;
}

/** The work with other details. A project whose task cannot be read stays as it is. */
export function withAbout(work: ShelfWork, about: TaskAbout): ShelfWork {
  const said = isSame(about, noAbout) ? {} : { about };
  if (work.kind === 'series') {
    const { about: _, ...series } = work.series;
    return { ...work, series: { ...series, ...said } };
  }
  const read = draftOf(work.project);
  if ('problem' in read) return work;
  return { ...work, project: projectOfTask({ ...withoutPart(read.task, 'about'), ...said }) };
}

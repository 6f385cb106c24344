import type { ProjectProblem } from '#project/problem';
import type { Project } from '#project/project';
import type { TaskAbout } from '../task/about';

/** Tasks in an order, which a teacher hands out together. */
export interface Series {
  /** Key under which this browser stores the progress: letters, digits, `_` and `-`. */
  readonly id: string;
  readonly title: string;
  /** Description; empty: none. */
  readonly text: string;
  readonly tasks: readonly SeriesTask[];
  /** Details for teachers; left out: none. */
  readonly about?: TaskAbout;
}

/** A task of a series. */
export interface SeriesTask {
  /** Unlike the others of the series. It stays when the order changes. */
  readonly id: string;
  /** Its title in the series; empty: the title of its course. */
  readonly title: string;
  readonly from: TaskSource;
}

/** Source of a task, or the reason why it is not available. */
export type TaskSource =
  /** The id of a ready course, with its program. */
  | { readonly kind: 'course'; readonly course: string }
  | { readonly kind: 'project'; readonly project: Project }
  /** A file beside that of the series: its address, seen from there. */
  | { readonly kind: 'file'; readonly file: string }
  | Unread;

/** A task that cannot be read. It keeps its place in the series. */
export interface Unread {
  readonly kind: 'unread';
  /** Its value in the file, so that nothing is lost when the series is saved again. */
  readonly value: unknown;
  /** In English, with the place in the file. */
  readonly problem: string;
  readonly problems: readonly ProjectProblem[];
  /** The reason, as worded by the code that looked for its file. */
  readonly said?: string;
}

/** Limits of a series. Chosen: a school year of lessons, which a page still shows at once. */
export const seriesLimits = {
  tasks: { min: 0, max: 60 },
  idCharacters: 40,
  titleCharacters: 120,
  textCharacters: 2000,
  fileCharacters: 1000,
  /** Size of the whole file. */
  characters: 12_000_000,
  /**
   * Maximum size of all links together, unpacked, which takes up to 5 µs a byte on a laptop (`#project/link`). Chosen: seconds at
   * the most; sixty tasks may have four times a drawing of 5,000 pen points each.
   */
  linkedBytes: 1024 * 1024,
} as const;

/** An id for a further task: a number that no other task has as its id. */
export function freeTaskId(tasks: readonly Pick<SeriesTask, 'id'>[]): string {
  for (let number = tasks.length + 1; ; number += 1)
    if (!tasks.some(({ id }) => id === String(number))) return String(number);
}

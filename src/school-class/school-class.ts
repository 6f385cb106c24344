import type { Day } from '#core/day';
import type { Scale } from './grades';

/** A class over a school year: its pupils, its tasks, and what was handed in. A file that the teacher owns. */
export interface SchoolClass {
  readonly name: string;
  /** In the order of the list that was pasted; those who came later behind them. */
  readonly pupils: readonly Pupil[];
  /** In the order in which they were first checked. */
  readonly tasks: readonly SetTask[];
  /** Each hand-in once, the oldest first. */
  readonly results: readonly Result[];
  /** `null`: no grades. */
  readonly scale: Scale | null;
}

/** Somebody in a class. */
export interface Pupil {
  /** Stays when the name is changed. Unlike the others of the class. */
  readonly id: string;
  readonly name: string;
  /** Further names that their hand-ins have. */
  readonly also: readonly string[];
  /** False: handed something in, and is not on the list. */
  readonly isListed: boolean;
}

/** A task that the class was set. */
export interface SetTask {
  /** The task's own id, else the mark of its course. */
  readonly id: string;
  readonly title: string;
  /** Points for passing all checks. */
  readonly points: number;
  /** True if it gives up to three stars. */
  readonly hasStars: boolean;
  /** Day of the first results. */
  readonly since: Day;
  /** Last day for handing in; `null`: none was set. */
  readonly due: Day | null;
}

/** The outcome of checking. What could not be read has neither points nor a grade. */
export const outcomes = ['passed', 'failed', 'unread'] as const;
export type Outcome = (typeof outcomes)[number];

/** The result of a hand-in. */
export interface Result {
  /** Id of the pupil. */
  readonly pupil: string;
  /** Id of the task. */
  readonly task: string;
  /** Day on which it was added first. */
  readonly day: Day;
  readonly outcome: Outcome;
  /** Points of the checks. */
  readonly points: number;
  /** Points that the teacher has set by hand, which count instead; left out: none. */
  readonly marked?: number;
  /** `null`: the task gives none. */
  readonly stars: number | null;
  /** Fingerprint of the program; empty: it has none. */
  readonly work: string;
  /** The teacher's note; empty: none. */
  readonly note: string;
}

/** Limits of a class. Chosen: a whole school of 300 pupils with 30 tasks has room. */
export const classLimits = {
  pupils: { min: 0, max: 1000 },
  names: { min: 0, max: 50 },
  tasks: { min: 0, max: 500 },
  results: { min: 0, max: 200_000 },
  nameCharacters: 120,
  titleCharacters: 200,
  idCharacters: 200,
  noteCharacters: 4000,
  points: { min: 0, max: 1_000_000 },
  stars: { min: 0, max: 3 },
  /** Size of the whole file. */
  characters: 60_000_000,
} as const;

/** A class of this name in which nobody is yet. */
export const newClass = (name: string): SchoolClass => ({ name, pupils: [], tasks: [], results: [], scale: null });

import type { Locks } from '../task/task';
import type { Verdict } from '#simulation/task/verdict';
import type { Carried, Project } from '#project/project';

/** What a pupil hands in. */
export interface HandIn {
  /** Program, course and settings as the pupil had them; without `handIn`. */
  readonly project: Project;
  /** The course is the pupil's: in a program alone there is none. */
  readonly hasCourse: boolean;
  /** What the pupil's page says; `null`: nothing, as in a program alone. */
  readonly said: Said | null;
  /** What the pupil's page kept locked; left out: nobody knows. */
  readonly locks?: Locks;
  /** Tells which course was handed out (`courseMark`); left out: nobody knows. */
  readonly mark?: string;
  /** It is a recorded run whose file was changed afterwards; left out: it was not, or it is something else. */
  readonly isEdited?: true;
}

/** What the pupil's page writes into a hand-in. It is told, and checked where it can be. */
export interface Said {
  /** Id of the task; empty: it has none. */
  readonly task: string;
  /** A name that the pupil has typed. */
  readonly alias: string;
  /** The best verdict so far. */
  readonly verdict: Verdict['state'];
  /** Number of runs. */
  readonly tries: number;
  /** Fingerprint of the ways of the robots in the visible world, until the verdict; empty: there is none. */
  readonly hash: string;
  /** What the page has noticed. */
  readonly remarks: readonly SaidRemark[];
}

/** What a page notices: the course was changed, the hand has moved something, the program was written elsewhere. */
export const saidRemarks = ['course', 'hand', 'outside'] as const;
export type SaidRemark = (typeof saidRemarks)[number];

/** Limits of what is read. */
export const handInLimits = { aliasCharacters: 60, tries: { min: 0, max: 1_000_000 }, hashCharacters: 64 } as const;

/** The version of a hand-in's own data. */
export const HAND_IN_VERSION = 1;

/** The project that is handed in: it opens on the page as the pupil's work. */
export function projectOfHandIn({ project, said }: HandIn): Project {
  if (said === null) return project;
  const handIn: Carried = { version: HAND_IN_VERSION, ...said };
  return { ...project, handIn };
}

import type { Locks } from '../task/task';
import type { Verdict } from '#simulation/task/verdict';
import type { Carried, Project } from '#project/project';

/** The work that a pupil hands in. */
export interface HandIn {
  /** Program, course and settings as the pupil had them; without `handIn`. */
  readonly project: Project;
  /** True if the course is the pupil's; false for a program alone, which has none. */
  readonly hasCourse: boolean;
  /** The pupil's page's statement about the work; `null`: none, as for a program alone. */
  readonly said: Said | null;
  /** Locks that were in force on the pupil's page; left out: unknown. */
  readonly locks?: Locks;
  /** Identifies the course that was handed out (`courseMark`); left out: unknown. */
  readonly mark?: string;
  /** The place of the level that was chosen; left out: none, or unknown. */
  readonly level?: number;
  /** True for a recorded run whose file was changed afterwards; left out: it was not, or it is something else. */
  readonly isEdited?: true;
  /** The coding of a program's file; left out: UTF-8, as boards want it. */
  readonly coding?: string;
}

/** The data that the pupil's page writes into a hand-in. It is reported, and verified where possible. */
export interface Said {
  /** Id of the task; empty: it has none. */
  readonly task: string;
  /** A name that the pupil has typed. */
  readonly alias: string;
  /** The best verdict so far. */
  readonly verdict: Verdict['state'];
  /** Number of runs. */
  readonly tries: number;
  /** Fingerprint of the robots' trails in the visible world, until the verdict; empty: none. */
  readonly hash: string;
  /** Irregularities that the page has noticed. */
  readonly remarks: readonly SaidRemark[];
}

/**
 * Irregularities that a page notices: the course was changed, the hand has moved something, the program was written
 * elsewhere.
 */
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

import type { Texts } from '#core/languages';
import type { Point } from '#scene/scene';
import type { Unread } from './hand-in/unread';
import type { Reason as GoalReason } from '#simulation/task/verdict';

/** Result of checking a hand-in: plain data without wall times, so that equal work gives equal results. */
export interface CheckResult {
  readonly passed: boolean;
  readonly points: number;
  /** `null`: the task gives none. */
  readonly stars: number | null;
  /** Each check of the task, in its order. */
  readonly checks: readonly CheckOutcome[];
  /** Each world of the task, in its order; none for what cannot be run. */
  readonly worlds: readonly WorldResult[];
  readonly remarks: readonly Remark[];
  /** Fingerprint that hand-ins with the same program share; empty for a program that is still as it was handed out. */
  readonly twin: string;
}

/** Result of a check of the task: passed in all worlds, or in enough of them. */
export interface CheckOutcome {
  readonly id: string;
  readonly passed: boolean;
  /** The reason, if it does not hold, of the first world in which it does not; `null`: it holds. */
  readonly reason: Reason | null;
}

/** Result in one world. */
export interface WorldResult {
  readonly id: string;
  readonly hidden: boolean;
  readonly passed: boolean;
  /** The reason, if it is not passed; else `null`. */
  readonly reason: Reason | null;
  /** Simulated ms until it was decided; `null`: it was not. */
  readonly atMs: number | null;
  readonly touches: number;
  /** The checks that hold in this world, by their ids. */
  readonly held: readonly string[];
  /** Why those that a run decides do not hold, by their ids. */
  readonly missed: Readonly<Record<string, Reason>>;
  /** Numbers of those reached, of the checks that give points for each, by their ids; left out where there are none. */
  readonly counts?: Readonly<Record<string, number>>;
  /** Fingerprint of the robots' trails until the end of the run. */
  readonly hash: string;
  /** The trail of the first robot in mm: pieces, without the parts where the hand lifted it. */
  readonly trail: readonly (readonly Point[])[];
  /** Simulated ms at which it was at each of these points. */
  readonly trailMs: readonly (readonly number[])[];
}

/** Why a check does not hold. */
export interface Reason {
  readonly code: ReasonCode;
  /** Values for the sentence about it. */
  readonly params: Readonly<Record<string, string | number>>;
  /** For an error of the program: its explanation and remedy, as the page's console gives them. */
  readonly advice?: Texts;
}

/** The codes of reasons, as reports and other programs have them. */
export const reasonCodes = [
  // of the course's goals
  ...(['time', 'forbidden', 'spikes', 'touched', 'robot', 'left', 'open', 'helped'] as const),
  // of a run that ended without a result
  ...(['empty', 'unmoved', 'waits'] as const),
  // of the other checks
  ...(['stop', 'whole', 'heading', 'reach', 'stay', 'laps', 'checkpoints', 'belongs', 'covered'] as const),
  ...(['tiles', 'score'] as const),
  ...(['touches', 'slow', 'early'] as const),
  ...(['display', 'light', 'sound', 'console', 'radio', 'log'] as const),
  ...(['loop', 'calls', 'lines', 'delay'] as const),
  // of the program
  ...(['exception', 'panic', 'stuck', 'long', 'refused', 'broken', 'unloaded'] as const),
] as const;
export type ReasonCode = (typeof reasonCodes)[number];

/** The codes of requirements that a run may still meet. */
const unreached: readonly ReasonCode[] = [
  ...(['open', 'empty', 'unmoved', 'waits', 'stop', 'whole', 'heading', 'reach', 'stay'] as const),
  ...(['laps', 'checkpoints', 'belongs', 'covered', 'tiles', 'score'] as const),
  ...(['display', 'light', 'sound', 'console', 'radio', 'log'] as const),
];

/** True if nothing was done wrong: something was just not reached. */
export const isUnreached = ({ code }: Reason): boolean => unreached.includes(code);

/** The code of a reason of the judge: it is the same word. */
export const reasonCode = (reason: GoalReason): ReasonCode => reason;

/** Something reported to the teacher. */
export interface Remark {
  readonly code: RemarkCode;
  readonly params: Readonly<Record<string, string | number>>;
}

/** The codes of remarks. */
export const remarkCodes = [
  // what cannot be read, or is for another task
  ...(['unreadable', 'other-task'] as const),
  // reported by the pupil's page
  ...(['hand', 'outside'] as const),
  // found by comparing
  ...(['course', 'unlocked', 'verdict', 'hash', 'no-hash', 'edited', 'coding', 'unchanged', 'twins'] as const),
] as const;
export type RemarkCode = (typeof remarkCodes)[number];

/** The result of a hand-in that cannot be read. */
export const unreadable = (checks: readonly { readonly id: string }[], { code, params }: Unread): CheckResult => ({
  passed: false,
  points: 0,
  stars: null,
  checks: checks.map(({ id }) => ({ id, passed: false, reason: null })),
  worlds: [],
  remarks: [{ code: 'unreadable', params: { ...params, why: code } }],
  twin: '',
});

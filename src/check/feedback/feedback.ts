import { isRecord } from '#core/record';
import { Reader } from '#scene/reader';
import type { Carried, Project } from '#project/project';
import { HAND_IN_VERSION } from '../hand-in/hand-in';
import { taskLimits } from '../task/task';
import { FEEDBACK, hasFeedback } from './has-feedback';

/**
 * A teacher's feedback on a hand-in. It travels in the pupil's own project, among what belongs to handing in, and goes
 * when that is handed in again.
 */
export interface Feedback {
  /** Plain text; empty: none. */
  readonly note: string;
  /** Id of the world whose run is looked at. */
  readonly world: string;
  /** The moment that is looked at, in simulated ms; `null`: the end of the program. */
  readonly atMs: number | null;
  /** True if it went wrong in that world. */
  readonly failed: boolean;
  /** Ids of the checks that do not hold. */
  readonly missed: readonly string[];
  /** Points of the hand-in and the most that there are; `null`: the task gives none. */
  readonly points: readonly [number, number] | null;
}

/** The version of this data that is written, and the newest that is read. */
export const FEEDBACK_VERSION = 1;

/** Limits of a feedback. */
export const feedbackLimits = {
  /** Chosen: some sentences, for which a card, a cell and a link have room. */
  noteCharacters: 500,
  atMs: { min: 0, max: taskLimits.seconds.max * 1000 },
  points: { min: 0, max: taskLimits.points.max * taskLimits.checks },
} as const;

/** The feedback in a project: none, one, or one that cannot be read. */
export type ReadFeedback = Feedback | null | 'damaged' | 'newer';

/** Reads the feedback in a project. Never throws. */
export function readFeedback({ handIn }: Pick<Project, 'handIn'>): ReadFeedback {
  const value = handIn?.[FEEDBACK];
  if (value === undefined) return null;
  if (!isRecord(value)) return 'damaged';
  const { version } = value;
  if (version !== FEEDBACK_VERSION)
    return typeof version === 'number' && version > FEEDBACK_VERSION ? 'newer' : 'damaged';
  const reader = new Reader();
  const { note, world, atMs, failed, missed, points } = reader.fields(value, FEEDBACK, [
    ...['version', 'note', 'world', 'atMs', 'failed', 'missed', 'points'],
  ]);
  const ids = missed === undefined ? [] : reader.list(missed, 'missed', { min: 0, max: taskLimits.checks });
  const feedback: Feedback = {
    note: reader.text(note, 'note', feedbackLimits.noteCharacters, ''),
    world: reader.text(world, 'world', taskLimits.idCharacters),
    atMs: atMs === undefined ? null : reader.number(atMs, 'atMs', feedbackLimits.atMs),
    failed: reader.flag(failed, 'failed', false),
    missed: ids.map((id) => reader.text(id, 'missed', taskLimits.idCharacters)),
    points: points === undefined ? null : pointsIn(points, reader),
  };
  return reader.problems.length > 0 ? 'damaged' : feedback;
}

function pointsIn(value: unknown, reader: Reader): Feedback['points'] {
  const [points, most] = reader.list(value, 'points', { min: 2, max: 2 });
  const { points: range } = feedbackLimits;
  return [reader.number(points, 'points', range), reader.number(most, 'points', range)];
}

/** Adds a feedback to what belongs to handing in. Usual values are left out. */
export const withFeedback = (handIn: Carried, { note, world, atMs, failed, missed, points }: Feedback): Carried => ({
  version: HAND_IN_VERSION,
  ...handIn,
  [FEEDBACK]: {
    version: FEEDBACK_VERSION,
    ...(note !== '' && { note }),
    world,
    ...(atMs !== null && { atMs }),
    ...(failed && { failed }),
    ...(missed.length > 0 && { missed }),
    ...(points !== null && { points }),
  },
});

/** The project without the feedback, for others than the pupil. */
export function withoutFeedback(project: Project): Project {
  if (!hasFeedback(project)) return project;
  const { handIn, ...others } = project;
  const { [FEEDBACK]: _, version, ...rest } = handIn ?? {};
  return Object.keys(rest).length === 0 ? others : { ...others, handIn: { version, ...rest } };
}

/** True while the moment that a feedback is about is looked at: moments are some ms apart. */
export const isAtMoment = ({ atMs }: Feedback, nowUs: number, endUs: number): boolean =>
  Math.abs((atMs === null ? endUs : Math.min(atMs * 1000, endUs)) - nowUs) <= MOMENT_US;

/** Recorded moments are this far apart at most. Chosen: five pictures of the page. */
const MOMENT_US = 100_000;

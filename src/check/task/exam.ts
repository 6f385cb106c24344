import type { Reader } from '#scene/reader';
import type { Carried } from '#project/project';

/** A task as an exam: pupils begin when they press the button, and when the time is over the program stays as it is. */
export interface Exam {
  readonly minutes: number;
}

/** Limits of an exam. Chosen: the longest of a school day. */
export const examLimits = { minutes: { min: 1, max: 480 } } as const;

/** Reads the exam of a task; `undefined`: it is none. */
export function readExam(value: unknown, reader: Reader): Exam | undefined {
  if (value === undefined) return undefined;
  const { minutes } = reader.fields(value, 'task.exam', ['minutes']);
  return { minutes: reader.whole(minutes, 'task.exam.minutes', examLimits.minutes) };
}

/** When a pupil has begun an exam, in ms since 1970; `null`: not yet. */
export function begunAt(handIn: Carried | undefined): number | null {
  const begun = handIn?.['begunMs'];
  return typeof begun === 'number' && Number.isFinite(begun) && begun > 0 ? begun : null;
}

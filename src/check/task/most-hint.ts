import type { Reader } from '#scene/reader';

/**
 * The most that a hint to a pupil's program may tell: nothing, the moment at which it went wrong, also the lines, also the
 * kind of change that helps, also the change itself.
 */
export const mostHints = ['off', 'moment', 'lines', 'kind', 'change'] as const;
export type MostHint = (typeof mostHints)[number];

/** Chosen: it leads to the fault, and leaves the mending to the pupil. */
export const USUAL_HINT: MostHint = 'kind';

/** Reads the most that hints of a task tell; `undefined`: the task does not say, or says what is usual. */
export function readMostHint(value: unknown, reader: Reader): MostHint | undefined {
  const most = reader.word(value, 'task.hint', mostHints, USUAL_HINT);
  return most === USUAL_HINT ? undefined : most;
}

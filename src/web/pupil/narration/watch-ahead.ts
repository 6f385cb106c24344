import type { Moment } from './moment';
import type { Watcher } from './news';

/**
 * Something ahead is announced when it comes nearer than each of these, in mm. Chosen: a robot drives 20 cm in a
 * second.
 */
const NEARER_MM = [500, 300, 200, 100];
/** … and again only after it was so much farther away, in mm. Chosen: more than readings jump while a robot sways. */
const BEYOND_MM = 50;
/**
 * Number of the distances above within which something must have been for the path to be announced as clear again: 2,
 * nearer than 300 mm.
 */
const CLEAR_FROM_STEP = 2;

/**
 * Finds out when something ahead comes nearer, in steps, and when the way is clear again. What is ahead at the start is
 * no news.
 */
export function watchAhead(): Watcher {
  let step: number | null = null;
  return (seen) => {
    if (seen.ahead === undefined) return [];
    const mm = seen.ahead?.mm ?? Infinity;
    const before = step;
    step = stepAt(mm, before ?? 0);
    if (before === null) return [];
    if (step > before) return [{ topic: 'ahead', isClear: false, seen }];
    return step === 0 && before >= CLEAR_FROM_STEP ? [{ topic: 'ahead', isClear: true, seen }] : [];
  };
}

/** True if something ahead is near enough to be announced. */
export const isNear = ({ ahead }: Moment): boolean => stepAt(ahead?.mm ?? Infinity, 1) > 0;

/** Number of the distances that something is nearer than; those that it has passed count a little longer. */
const stepAt = (mm: number, before: number): number =>
  NEARER_MM.filter((edge, at) => mm < edge + (at < before ? BEYOND_MM : 0)).length;

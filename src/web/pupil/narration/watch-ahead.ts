import type { Moment } from './moment';
import type { Watcher } from './news';

/** Something ahead is told when it comes nearer than each of these, in mm. Chosen: a robot drives 20 cm in a second. */
const NEARER_MM = [500, 300, 200, 100];
/** … and again only after it was so much farther away, in mm. Chosen: more than readings jump while a robot sways. */
const BEYOND_MM = 50;
/** Distance in mm beyond which the path is announced as clear again after something nearer was. */
const CLEAR_FROM_STEP = 2;

/** Tells of what comes nearer ahead, in steps, and when the way is clear again. What is there at the start is said then. */
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

/** True if something is ahead that is worth telling of. */
export const isNear = ({ ahead }: Moment): boolean => stepAt(ahead?.mm ?? Infinity, 1) > 0;

/** How many of the distances it is nearer than; those already passed hold a little longer. */
const stepAt = (mm: number, before: number): number =>
  NEARER_MM.filter((edge, at) => mm < edge + (at < before ? BEYOND_MM : 0)).length;

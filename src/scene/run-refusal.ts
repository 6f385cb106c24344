import { unpackLevels } from './background';
import { isHeap, MOST_STUCK_PAIRS } from './overlaps';
import type { Scene } from './scene';

/** Maximum number of movers in a run. Chosen: each checks all it might push; 2000 take a second for a step. */
const MOST_MOVERS = 100;

/** The message about a background whose grid cannot be unpacked. */
export const DAMAGED_BACKGROUND =
  'background.levels: the picture on the floor is damaged. Take it in anew, or remove it.';

/** Why no run can begin in a course, whatever robot it is for. */
export interface RunRefusal {
  readonly code: 'heap' | 'movers' | 'background';
  /** One English sentence with the remedy. */
  readonly message: string;
  readonly params: Readonly<Record<string, number>>;
}

/** Why no run can begin in a course, or `null`: what would take far too long, or cannot be read. */
export function runRefusal({ objects, background }: Scene): RunRefusal | null {
  if (isHeap(objects)) {
    const message = `objects: blocks stand inside each other or inside other things at more than ${String(MOST_STUCK_PAIRS)} places. Move them apart, or remove some.`;
    return { code: 'heap', message, params: { max: MOST_STUCK_PAIRS } };
  }
  const movers = objects.filter(({ type }) => type === 'mover').length;
  if (movers > MOST_MOVERS) {
    const message = `objects: ${String(movers)} moving obstacles are too many for a run; the limit is ${String(MOST_MOVERS)}. Remove some.`;
    return { code: 'movers', message, params: { count: movers, max: MOST_MOVERS } };
  }
  if (background === null || unpackLevels(background) !== null) return null;
  return { code: 'background', message: DAMAGED_BACKGROUND, params: {} };
}

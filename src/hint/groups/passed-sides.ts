import type { CheckResult } from '#check/result';
import type { Point } from '#scene/scene';

/** The side on which a way goes round what lies between its ends, or the direction in which it goes round its beginning. */
export const passedSides = ['left', 'right', 'clockwise', 'counter'] as const;
export type PassedSide = (typeof passedSides)[number];

/** A way whose ends are closer than this goes round, in mm; another one has a side from this mean distance on. Chosen. */
const [ROUND_MM, SIDE_MM] = [200, 80];

/**
 * The sides on which ways that have passed went, by name, if they differ; else none: then there is nothing to tell apart.
 * A way that went straight on has none.
 */
export function sidesIn(
  passed: readonly { readonly name: string; readonly result: CheckResult }[],
): ReadonlyMap<string, PassedSide> {
  const sides = new Map<string, PassedSide>();
  for (const { name, result } of passed) {
    const side = sideOf(result.worlds[0]?.trail.flat() ?? []);
    if (side !== null) sides.set(name, side);
  }
  const differ = (one: PassedSide, other: PassedSide): boolean => [one, other].every((side) => [...sides.values()].includes(side)); // prettier-ignore
  return differ('left', 'right') || differ('clockwise', 'counter') ? sides : new Map();
}

function sideOf(way: readonly Point[]): PassedSide | null {
  const [first, last] = [way[0], way.at(-1)];
  if (first === undefined || last === undefined) return null;
  const chord = Math.sqrt((last[0] - first[0]) * (last[0] - first[0]) + (last[1] - first[1]) * (last[1] - first[1]));
  let doubled = 0;
  for (const [index, [x, y]] of way.entries()) {
    const [toX, toY] = way[index + 1] ?? first;
    doubled += x * toY - toX * y;
  }
  const area = doubled / 2;
  if (chord < ROUND_MM) return Math.abs(area) < ROUND_MM * ROUND_MM ? null : area > 0 ? 'counter' : 'clockwise';
  if (Math.abs(area) < chord * SIDE_MM) return null;
  return area > 0 ? 'right' : 'left';
}

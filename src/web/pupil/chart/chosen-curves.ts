import { shallowRef } from 'vue';

import { lateModel } from '../../kit/state/late-models';
import { MOST_CURVES } from './plot/looks';
import type { Series } from './series/series';

/** Most units that have an axis: one at the left, one at the right. */
const MOST_UNITS = 2;

/** The ids of the curves that somebody has chosen, for as long as the page is open; `null`: nobody has. */
export const chosenCurves = lateModel(() => shallowRef<readonly string[] | null>(null));

/** True if a curve can be drawn beside those that are drawn. */
export function canJoin({ unit }: Series, drawn: readonly Series[]): boolean {
  const units = new Set([...drawn.map((series) => series.unit), unit]);
  return drawn.length < MOST_CURVES && units.size <= MOST_UNITS;
}

/** The curves with these ids that can be drawn together, in that order. */
export function drawable(ids: readonly string[], all: readonly Series[]): readonly Series[] {
  const drawn: Series[] = [];
  for (const id of ids) {
    const series = all.find((it) => it.id === id);
    if (series !== undefined && canJoin(series, drawn)) drawn.push(series);
  }
  return drawn;
}

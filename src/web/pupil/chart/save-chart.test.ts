import { describe, expect, it } from 'vitest';
import { canJoin, drawable } from './chosen-curves';
import { lookAt } from './plot/looks';
import { csvOfCurves, rangeWithin, sampledRows } from './save-chart';
import type { Series } from './series/series';

const series = (id: string, unit = ''): Series => ({ id, name: id, unit, isStepped: false });
const curve = (name: string, unit: string, ...points: readonly (readonly [number, number | null])[]) => ({
  series: series(name, unit),
  look: lookAt(0),
  points: { timesS: points.map(([timeS]) => timeS), values: points.map(([, value]) => value) },
});

describe('curves as a table', () => {
  it('have a row for each time, with empty cells where a curve has no value of its own', () =>
    expect(
      csvOfCurves([curve('a, b', 'cm', [0.02, 1.5], [0.04, null]), curve('c', '', [0.04, 3])], [0, 1], 'Zeit'),
    ).toBe('Zeit (s),"a, b (cm)",c\n0.02,1.5,\n0.04,,3\n'));

  it('are those of the stretch that is shown', () =>
    expect(csvOfCurves([curve('a', '', [1, 1], [2, 2], [3, 3])], [1.5, 2.5], 't')).toBe('t (s),a\n2,2\n'));

  it('have, for the ear, values at even distances: the last one before each', () =>
    expect(sampledRows([curve('a', '', [1, 10], [2, 20])], [0, 2], 3)).toEqual([
      [0, null],
      [1, 10],
      [2, 20],
    ]));

  it('tell from where to where their values go', () => {
    expect(rangeWithin(curve('a', '', [1, 4], [2, -2], [3, 9]), [0, 2])).toEqual([-2, 4]);
    expect(rangeWithin(curve('a', '', [1, null]), [0, 2])).toBeNull();
  });
});

describe('the choice of curves', () => {
  it('ends at four', () => {
    const four = ['a', 'b', 'c', 'd'].map((id) => series(id));
    expect(canJoin(series('e'), four)).toBe(false);
    expect(canJoin(series('e'), four.slice(1))).toBe(true);
  });

  it('ends at two units, one for each axis', () => {
    const two = [series('a', 'cm'), series('b', '°')];
    expect(canJoin(series('c', 'mg'), two)).toBe(false);
    expect(canJoin(series('c', 'cm'), two)).toBe(true);
  });

  it('leaves out what this run does not have', () =>
    expect(drawable(['x', 'a'], [series('a')]).map(({ id }) => id)).toEqual(['a']));
});

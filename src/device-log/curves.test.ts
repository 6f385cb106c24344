import { describe, expect, it } from 'vitest';

import { compare, rangeOf, thinned, type Point } from './curves';
import { ticksFor } from './ticks';
import { timeOf } from './time-heading';

const tableOf = (text: string) => {
  const [headings = [], ...rows] = text.split('\n').map((line) => line.split(','));
  return { headings, rows };
};
const none = { headings: [], rows: [] };

describe('the curves of a device and of the simulation', () => {
  it('come into one chart by their names, over the time in seconds', () => {
    const device = tableOf('Time (milliseconds),cm,light\n500,12,7\n1500,11,8');
    const simulation = tableOf('Time (seconds),cm,temp\n0.50,13,20');
    expect(compare(device, simulation)).toEqual({
      axis: { kind: 'seconds' },
      isWithoutCommonTime: false,
      charts: [
        { heading: 'cm', device: [[[0.5, 12], [1.5, 11]]], simulation: [[[0.5, 13]]] },
        { heading: 'light', device: [[[0.5, 7], [1.5, 8]]], simulation: [] },
        { heading: 'temp', device: [], simulation: [[[0.5, 20]]] },
      ],
    }); // prettier-ignore
  });

  it('stand over the number of the row if there is no time, or not of one kind', () => {
    expect(compare(tableOf('cm\n4\n5'), none)).toMatchObject({ axis: { kind: 'rows' }, isWithoutCommonTime: false });
    const mixed = compare(tableOf('t,cm\n100,4\n200,5'), tableOf('Time (seconds),cm\n1,4'));
    expect(mixed).toMatchObject({ axis: { kind: 'rows' }, isWithoutCommonTime: true });
    expect(mixed.charts[0]?.device).toEqual([[[1, 4], [2, 5]]]); // prettier-ignore
  });

  it('keep a time without a unit as it is', () =>
    expect(compare(tableOf('t,cm\n100,4'), none)).toMatchObject({ axis: { kind: 'own', heading: 't' } }));

  it('begin anew where the board was started again, and after what is no number', () => {
    const { charts } = compare(tableOf('Time (seconds),x\n1,1\n2,2\n0.5,3\n1,nan\n2,4'), none);
    expect(charts[0]?.device).toEqual([[[1, 1], [2, 2]], [[0.5, 3]], [[2, 4]]]); // prettier-ignore
  });

  it('go on over rows in which nothing was logged for them', () => {
    const { charts } = compare(tableOf('Time (seconds),x,y\n1,1,\n2,,5\n3,2,'), none);
    expect(charts[0]?.device).toEqual([[[1, 1], [3, 2]]]); // prettier-ignore
  });

  it('take the unit that has a value after it was changed', () => {
    const { charts } = compare(tableOf('Time (seconds),x,Time (minutes)\n30,1,\n,2,1'), none);
    expect(charts[0]?.device).toEqual([[[30, 1], [60, 2]]]); // prettier-ignore
  });

  it('have no chart for words', () => expect(compare(tableOf('t,note\n1,go'), none).charts).toEqual([]));
});

describe('a column of times', () => {
  it.each([
    ['Time (seconds)', 1],
    ['Time (milliseconds)', 0.001],
    ['Time (sec.)', 1],
    ['Time (hrs.)', 3600],
    ['Time (days)', 86_400],
    ['Zeit [min]', 60],
    ['Temps (heures)', 3600],
    ['tempo (ore)', 3600],
    ['t_ms', 0.001],
    ['t', null],
    ['Zeit', null],
  ])('may be called %s', (heading, unitS) => expect(timeOf(heading)).toEqual({ unitS }));

  it.each(['cm', 'temp', 'times', 't5', 'tms', 'time left', 'Time (cm)'])('is not called %s', (heading) =>
    expect(timeOf(heading)).toBeNull(),
  );
});

describe('a thinned line', () => {
  const long: Point[] = Array.from({ length: 100_000 }, (_, at) => [at, at === 51_234 ? 900 : at % 7]);

  it('has few points, and its peak still', () => {
    const few = thinned(long, 300);
    expect(few.length).toBeLessThanOrEqual(1200);
    expect(few).toContainEqual([51_234, 900]);
    expect(rangeOf([few], 1)).toEqual([0, 900]);
    expect([few[0], few.at(-1)]).toEqual([long[0], long.at(-1)]);
  });

  it('stays as it is if it has few points', () => expect(thinned(long.slice(0, 100), 300)).toHaveLength(100));
});

describe('round values beside an axis', () => {
  it.each([
    [0, 40, 4, [0, 10, 20, 30, 40]],
    [3, 41, 4, [0, 10, 20, 30, 40, 50]],
    [0.1, 0.3, 2, [0.1, 0.2, 0.3]],
    [-5, 5, 2, [-5, 0, 5]],
    [7, 7, 2, [0, 5, 10, 15]],
    [0, 0, 2, [-0.5, 0, 0.5]],
  ])('from %d to %d', (min, max, about, ticks) => expect(ticksFor(min, max, about)).toEqual(ticks));
});

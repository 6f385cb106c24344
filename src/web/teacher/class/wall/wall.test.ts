import { describe, expect, it } from 'vitest';

import { unreadable, type CheckResult } from '#check/result';

import type { Row } from '../model/class-model';
import { drivenUntil, lastMs } from './timed-way';
import { gridFor, Lots, wallCards, type Naming, type WallOrder } from './wall-cards';

const row = (name: string, atMs: number | null): Row => {
  const world: CheckResult['worlds'][number] = {
    ...{ id: 'visible', hidden: false, passed: atMs !== null, reason: null, atMs, touches: 0 },
    ...{ held: [], missed: {}, hash: '', trail: [], trailMs: [] },
  };
  const result = { passed: atMs !== null, points: 1, stars: null, checks: [], worlds: [world], remarks: [], twin: '' };
  return { name, shown: name, handIn: null, note: '', result };
};
const rows: readonly Row[] = [
  row('Cem', 9000),
  row('Ben', null),
  row('Ada', 20_000),
  { name: 'Eva', shown: 'Eva', handIn: null, note: '', result: unreadable([], { code: 'zip', params: {} }) },
  { name: 'Dan', shown: 'Dan', handIn: null, note: '', result: null },
];
/** The last one that is waiting is drawn first: Dan 1, Eva 2, Ada 3, Ben 4, Cem 5. */
const shown = (naming: Naming, order: WallOrder, some = rows): readonly (string | number)[] =>
  wallCards(some, new Lots(() => 0.999), { naming, order, language: 'de' }).map(({ name, number }) => name ?? number);

describe('the wall of results', () => {
  it('names those who have passed; the others have numbers, and stand behind them', () => {
    expect(shown('passed', 'came')).toEqual(['Cem', 'Ada', 1, 2, 4]);
    expect(shown('passed', 'name')).toEqual(['Ada', 'Cem', 1, 2, 4]);
    expect(shown('passed', 'fastest')).toEqual(['Cem', 'Ada', 1, 2, 4]);
  });

  it('names all or nobody, if the teacher wants that', () => {
    expect(shown('all', 'came')).toEqual(['Cem', 'Ben', 'Ada', 'Eva', 'Dan']);
    expect(shown('all', 'name')).toEqual(['Ada', 'Ben', 'Cem', 'Dan', 'Eva']);
    expect(shown('none', 'name')).toEqual([1, 2, 3, 4, 5]);
    expect(shown('none', 'fastest')).toEqual([5, 3, 1, 2, 4]);
  });

  it('tells a time only of those who have passed', () => {
    const cards = wallCards([row('Ada', 5000), { ...row('Ben', 7000), result: { ...row('Ben', 7000).result!, passed: false } }], new Lots(), { naming: 'all', order: 'came', language: 'de' }); // prettier-ignore
    expect(cards.map(({ passedMs }) => passedMs)).toEqual([5000, null]);
  });

  it('keeps a number once it is drawn, whoever comes later', () => {
    const lots = new Lots(() => 0.5);
    const before = [...lots.of(['Ada', 'Ben', 'Cem'])];
    const after = lots.of(['Zoe', 'Ada', 'Yann', 'Ben', 'Cem']);
    expect(before.map(([name]) => after.get(name))).toEqual(before.map(([, number]) => number));
    expect([...after.values()].toSorted()).toEqual([1, 2, 3, 4, 5]);
  });

  it('draws numbers by lot: the first of the list is not always number 1', () => {
    const ofFirst = Array.from({ length: 60 }, () => new Lots().of(['Ada', 'Ben', 'Cem', 'Dan']).get('Ada'));
    expect(new Set(ofFirst).size).toBeGreaterThan(1);
  });
});

describe('the cards of a wall', () => {
  const aspect = 1200 / 900;
  /** True if they fit without scrolling, and how wide a drawing is. */
  const laidOut = (count: number, width: number, height: number) => {
    const { columns, rowPx, namePx } = gridFor(count, { width, height }, aspect);
    const lines = Math.ceil(count / columns);
    const drawingPx = Math.min(width / columns, (rowPx - 12 - 2.4 * namePx) * aspect);
    return { columns, fits: lines * rowPx + (lines - 1) * 8 <= height, drawingPx };
  };

  it('fill the screen: one, 24 and 40 fit on a projector of 1280 × 720 without scrolling', () => {
    for (const count of [1, 5, 24, 30, 40]) expect([count, laidOut(count, 1264, 636).fits]).toEqual([count, true]);
    expect(laidOut(24, 1264, 636).columns).toBe(8);
    expect(laidOut(24, 1264, 636).drawingPx).toBeGreaterThan(140);
  });

  it('are larger on a larger screen', () => {
    expect(laidOut(24, 1904, 996).drawingPx).toBeGreaterThan(1.5 * laidOut(24, 1264, 636).drawingPx);
  });

  it('scroll on a phone, two beside one another', () => {
    expect(laidOut(24, 374, 700)).toMatchObject({ columns: 2, fits: false });
    expect(laidOut(24, 374, 700).drawingPx).toBeGreaterThan(160);
  });
});

describe('a way in simulated time', () => {
  const way = { trail: [[[0, 0], [100, 0], [100, 100]], [[500, 500], [600, 500]]], trailMs: [[0, 1000, 3000], [5000, 6000]] } as const; // prettier-ignore

  it('grows: at 2 s the robot is half-way between the points of 1 s and 3 s', () => {
    expect(drivenUntil(way, 2000)).toEqual([[[0, 0], [100, 0], [100, 50]]]); // prettier-ignore
    expect(drivenUntil(way, 4000)).toEqual([way.trail[0]]);
    expect(drivenUntil(way, 5500)).toEqual([way.trail[0], [[500, 500], [550, 500]]]); // prettier-ignore
    expect(drivenUntil(way, 60_000)).toEqual(way.trail);
  });

  it('is over with the last of all ways', () => {
    expect(
      lastMs([
        { way, passedMs: null },
        { way: { trail: [], trailMs: [] }, passedMs: null },
      ]),
    ).toBe(6000);
  });

  it('is not over before the last has passed: who must stand for a second is at the end of the way before', () => {
    expect(
      lastMs([
        { way, passedMs: 7020 },
        { way, passedMs: null },
      ]),
    ).toBe(7020);
  });
});

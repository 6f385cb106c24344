import { describe, expect, it } from 'vitest';
import { createRng } from '#core/rng';
import { RowWriter } from './row-writer';
import { Rows } from './rows';

interface Moment {
  readonly timeUs: number;
  readonly [name: string]: unknown;
}

/** Rows of moments that come one after the other. */
function rowsOf(moments: readonly Moment[], mostBytes?: number): Rows<Moment> {
  const writer = new RowWriter();
  const rows = new Rows<Moment>(mostBytes);
  for (const moment of moments) {
    const piece = writer.add(moment);
    if (piece) expect(rows.push(piece)).not.toBeNull();
  }
  const last = writer.finish();
  if (last) expect(rows.push(last)).not.toBeNull();
  return rows;
}

const every20ms = (count: number, at: (n: number) => object): readonly Moment[] =>
  Array.from({ length: count }, (_, n) => ({ timeUs: n * 20_000, ...at(n) }));

describe('a tape gives back', () => {
  it('texts, truth, nothing, empty lists and lists in lists as they were', () => {
    const moment = { timeUs: 0, name: 'main.py', on: true, sound: null, none: [], empty: {}, list: [[1, 2], [3]] };
    expect(rowsOf([moment]).at(0)).toEqual(moment);
  });

  it('lengths to a tenth of a millimetre, angles to a thousandth of a radian', () => {
    const pose = { xMm: 123.456, yMm: -0.04, headingRad: 3.14159 };
    expect(rowsOf([{ timeUs: 7, pose }]).at(7)).toEqual({ timeUs: 7, pose: { xMm: 123.5, yMm: 0, headingRad: 3.142 } });
  });

  it('the last moment at or before a time, and the first one before all', () => {
    const rows = rowsOf(every20ms(600, (n) => ({ n })));
    expect(rows.at(0)).toMatchObject({ n: 0 });
    expect(rows.at(19_999)).toMatchObject({ n: 0 });
    expect(rows.at(20_000)).toMatchObject({ n: 1 });
    expect(rows.at(7_777_777)).toMatchObject({ n: 388 });
    expect(rows.at(99_999_999)).toMatchObject({ n: 599 });
    expect(rows.endUs).toBe(599 * 20_000);
    expect(rowsOf([{ timeUs: 500, n: 1 }]).at(0)).toMatchObject({ n: 1 });
  });

  it('things that come and go, and what changes from a figure to something else', () => {
    const moments = every20ms(700, (n) => ({
      distanceMm: n % 90 < 20 ? null : 300 + (n % 7),
      ...(n % 300 < 100 ? {} : { blocks: { [`b${n % 3}`]: { xMm: n } } }),
      robot: n > 400 ? null : { servos: n > 350 ? { 1: 90 } : {} },
    }));
    const rows = rowsOf(moments);
    for (const moment of moments) expect(rows.at(moment.timeUs)).toEqual(moment);
  });

  it('any data at any moment', () => {
    const chance = createRng(5);
    const leaf = (): unknown =>
      [null, true, false, '', 'ä', [], {}, Math.round(chance.unit() * 1e9), -5][Math.floor(chance.unit() * 9)];
    const data = (depth: number): unknown => {
      if (depth === 0 || chance.unit() < 0.3) return leaf();
      if (chance.unit() < 0.5) return Array.from({ length: 1 + Math.floor(chance.unit() * 3) }, () => data(depth - 1));
      return Object.fromEntries(['a', 'b', 'c'].filter(() => chance.unit() < 0.7).map((key) => [key, data(depth - 1)]));
    };
    const moments = every20ms(400, () => ({ thing: data(3), other: data(2) }));
    const rows = rowsOf(moments);
    for (const moment of moments) expect(rows.at(moment.timeUs)).toEqual(moment);
  });
});

describe('a tape that gets long', () => {
  const chance = createRng(3);
  const moments = every20ms(5000, (n) => ({ xMm: Math.floor(chance.unit() * 1000), n }));

  it('loses every second moment, the oldest first, and stays within its size', () => {
    const whole = rowsOf(moments);
    const most = Math.round(whole.bytes * 0.8);
    const rows = rowsOf(moments, most);
    expect(rows.bytes).toBeLessThanOrEqual(most);
    expect(rows.endUs).toBe(whole.endUs);
    expect(rows.at(4999 * 20_000)).toEqual(moments[4999]);
    expect(rows.at(4998 * 20_000)).toEqual(moments[4998]);
    const early = rows.at(1001 * 20_000) as Moment;
    expect(early['n']).toBeLessThan(1001);
    expect(moments[Number(early['n'])]).toEqual(early);
  });
});

describe('what is no piece of a tape', () => {
  const writer = new RowWriter();
  for (let n = 0; n < 100; n++) writer.add({ timeUs: n, ...{ xMm: n * 3 } });
  const piece = writer.finish() ?? new Uint8Array();

  it('is refused, and the rows stay', () => {
    const rows = new Rows();
    expect(rows.push(piece)).not.toBeNull();
    for (const bytes of [new Uint8Array(), piece.slice(0, -9), Uint8Array.from(piece, (byte) => byte ^ 0x55)])
      expect(rows.push(bytes)).toBeNull();
    expect(rows.at(50)).toEqual({ timeUs: 50, xMm: 150 });
  });

  it('is refused where it belongs before what is there', () => {
    const rows = new Rows();
    expect(rows.push(piece)).not.toBeNull();
    expect(rows.push(piece)).toBeNull();
  });
});

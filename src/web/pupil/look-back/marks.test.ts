import { describe, expect, it } from 'vitest';
import { RowWriter } from '#tape/rows/row-writer';
import { Rows } from '#tape/rows/rows';
import { grouped, Marks, type Mark } from './marks';

interface Moment {
  readonly timeUs: number;
}

/** The marks of moments, of which each adds something to the one before. */
function marksOf(devices: number, ...changes: readonly object[]): readonly (readonly unknown[])[] {
  const [writer, rows, marks] = [new RowWriter(), new Rows<Moment>(), new Marks(devices)];
  let moment: Moment = { timeUs: 0 };
  for (const change of changes) {
    moment = { ...moment, ...change, timeUs: moment.timeUs + 20_000 };
    // A piece for each moment: what changes between two pieces counts, too.
    writer.add(moment);
    const piece = writer.finish();
    const chunk = piece && rows.push(piece);
    if (chunk) marks.add(chunk);
  }
  return marks.all.map(({ timeUs, kind, device }) => [timeUs / 1000, kind, device]);
}

const buttons = (a: boolean, b: boolean) => ({ buttons: { a, b } });
const verdict = (state: string, passed: number) => ({
  verdict: { state, checkpoints: { passed }, targets: { reached: 0 }, blocks: { delivered: 0 } },
});

describe('the time line marks', () => {
  it('mark when a button goes down, not that it is down', () =>
    expect(marksOf(1, buttons(false, false), buttons(true, false), buttons(true, true), buttons(false, true))).toEqual([
      [40, 'pressA', 0],
      [60, 'pressB', 0],
    ]));

  it('each touch of the robot of each device', () =>
    expect(
      marksOf(
        2,
        { robot: { collisions: 0 }, others: [{ robot: { collisions: 0 } }] },
        { robot: { collisions: 1 } },
        { others: [{ robot: { collisions: 2 } }] },
      ),
    ).toEqual([
      [40, 'touch', 0],
      [60, 'touch', 1],
    ]));

  it('checkpoints and how the task ended', () =>
    expect(marksOf(1, verdict('open', 0), verdict('open', 1), verdict('passed', 2), verdict('passed', 2))).toEqual([
      [40, 'checkpoint', null],
      [60, 'checkpoint', null],
      [60, 'passed', null],
    ]));

  it('the end of the program', () =>
    expect(marksOf(1, { running: 'program' }, { running: 'world' }, { running: 'world' })).toEqual([[40, 'end', 0]]));
});

describe('marks that stand close together', () => {
  const mark = (timeUs: number, kind: Mark['kind'] = 'touch', device: number | null = 0): Mark => ({
    timeUs,
    kind,
    device,
  });

  it('are one sign with their number, from the first to the last; others keep their own', () =>
    expect(grouped([mark(10), mark(14), mark(15, 'pressA'), mark(18), mark(19, 'touch', 1), mark(30)], 5)).toEqual([
      { ...mark(10), count: 3, toUs: 18 },
      { ...mark(15, 'pressA'), count: 1, toUs: 15 },
      { ...mark(19, 'touch', 1), count: 1, toUs: 19 },
      { ...mark(30), count: 1, toUs: 30 },
    ]));
});

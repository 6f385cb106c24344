import { describe, expect, it } from 'vitest';
import type { Snapshot } from '#simulation/snapshot';
import { RowWriter } from '#tape/rows/row-writer';
import type { Reading } from './readings';
import { TapeSource } from './tape-source';

const reading = (id: string, more: Partial<Reading> = {}): Reading => ({
  ...{ id, name: id, unit: '', isStepped: false, isRate: false, paths: [[id]] },
  value: ([leaf]) => (typeof leaf === 'number' ? leaf : null),
  ...more,
});
const moment = (at: number, values: object, others: readonly object[] = []): Snapshot =>
  ({ timeUs: at * 20_000, ...values, others }) as unknown as Snapshot;

/** A tape of moments, a piece for every so many. */
function pieces(each: number, moments: readonly Snapshot[]): readonly Uint8Array[] {
  const writer = new RowWriter();
  return moments.flatMap((it, at) => {
    const full = writer.add(it);
    const piece = full ?? ((at + 1) % each === 0 ? writer.finish() : null);
    return piece ? [piece] : [];
  });
}
const read = (source: TapeSource, id: string) => {
  while (source.update(new Set([id])));
  const { timesS, values } = source.pointsOf(id);
  return timesS.map((timeS, at) => [Math.round(timeS * 1000), values[at]]);
};

describe('what a run measures', () => {
  const moments = [1, 2, 3, 4].map((at) => moment(at, { cm: at * 10 }, [{ cm: at }]));

  it('is read from the pieces of its tape', () => {
    const run = { pieces: pieces(2, moments), present: null };
    expect(read(new TapeSource(() => '', [reading('cm')], 0, () => run), 'cm')).toEqual([[20, 10], [40, 20], [60, 30], [80, 40]]); // prettier-ignore
  });

  it('is that of the device that is asked for', () => {
    const run = { pieces: pieces(4, moments), present: null };
    expect(read(new TapeSource(() => '', [reading('cm')], 1, () => run), 'cm')).toEqual([[20, 1], [40, 2], [60, 3], [80, 4]]); // prettier-ignore
  });

  it('goes on with the picture that is shown, until the tape has that moment', () => {
    const run: { pieces: readonly Uint8Array[]; present: Snapshot | null } = { pieces: [], present: null };
    const source = new TapeSource(
      () => '',
      [reading('cm')],
      0,
      () => run,
    );
    run.present = moment(1.5, { cm: 15 });
    expect(read(source, 'cm')).toEqual([[30, 15]]);
    run.pieces = pieces(2, moments.slice(0, 2));
    run.present = moment(2.5, { cm: 25 });
    expect(read(source, 'cm')).toEqual([[20, 10], [40, 20], [50, 25]]); // prettier-ignore
  });

  it('is read from the begin when another curve is chosen later', () => {
    const run = { pieces: pieces(2, moments), present: null };
    const source = new TapeSource(
      () => '',
      [reading('cm'), reading('other', { paths: [['cm']] })],
      0,
      () => run,
    );
    read(source, 'cm');
    expect(read(source, 'other')).toHaveLength(4);
  });

  it('has gaps where there is nothing', () => {
    const run = {
      pieces: pieces(3, [moment(1, { cm: 1 }), moment(2, { cm: null }), moment(3, { cm: 3 })]),
      present: null,
    };
    expect(read(new TapeSource(() => '', [reading('cm')], 0, () => run), 'cm').map(([, value]) => value)).toEqual([1, null, 3]); // prettier-ignore
  });

  it('can be a speed: 3 mm each 20 ms are 150 mm/s, measured over 100 ms', () => {
    const run = {
      pieces: pieces(
        10,
        Array.from({ length: 10 }, (_, at) => moment(at + 1, { cm: at * 3 })),
      ),
      present: null,
    };
    const values = read(
      new TapeSource(
        () => '',
        [reading('cm', { isRate: true })],
        0,
        () => run,
      ),
      'cm',
    ).map(([, value]) => value);
    expect(values[0]).toBeNull();
    expect(values.slice(1).map((value) => Math.round(value ?? 0))).toEqual(new Array(9).fill(150));
  });
});

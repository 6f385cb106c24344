import { describe, expect, it } from 'vitest';

import type { Snapshot } from '#simulation/snapshot';
import { Rows } from '#tape/rows/rows';
import type { FromWorker } from './protocol';
import { TapeBox } from './tape-box';

/** A box, and how far the page knows the run. */
function taping() {
  const rows = new Rows<Snapshot>();
  const thin: (number | null)[] = [];
  const told: number[] = [];
  const pieces: Uint8Array[] = [];
  const box = new TapeBox((message: FromWorker) => {
    if (message.type === 'inputs') told.push(message.nowUs);
    if (message.type !== 'tape') return;
    thin.push(message.thinSinceUs);
    pieces.push(message.piece);
    expect(rows.push(message.piece)).not.toBeNull();
  });
  let timeUs = 0;
  const snapshot = (): Snapshot => ({ timeUs }) as Snapshot;
  /** Lets this number of moments of 20 ms pass. */
  const pass = (moments: number): void => {
    for (let n = 0; n < moments; n++) {
      timeUs += 20_000;
      if (box.isMomentWanted(timeUs)) box.moment(snapshot());
    }
    box.tell();
  };
  const run = (): Parameters<TapeBox['tellAll']>[0] => ({ nowUs: timeUs, inputLog: [], snapshot });
  const timesUs = (): number[] => {
    const all = new Set<number>();
    for (let us = 0; us <= rows.endUs; us += 20_000) all.add(rows.at(us)?.timeUs ?? -1);
    return [...all];
  };
  return { box, pass, run, thin, told, timesUs, knownUs: () => rows.endUs, pieces };
}

describe('the tape on its way to the page', () => {
  it('goes in pieces of five seconds while a program runs', () => {
    const { pass, knownUs } = taping();
    pass(249);
    expect(knownUs()).toBe(-1);
    pass(1);
    expect(knownUs()).toBe(5_000_000);
  });

  it('is there to the last moment when the programs end, and then each second', () => {
    const { box, pass, run, knownUs, pieces, told } = taping();
    pass(30);
    box.setOver(true, run());
    expect([knownUs(), told]).toEqual([600_000, [600_000]]);
    pass(49);
    expect(knownUs()).toBe(600_000);
    pass(1);
    expect(knownUs()).toBe(1_600_000);
    expect(pieces).toHaveLength(2);
  });

  it('goes on in long pieces when a program begins anew', () => {
    const { box, pass, run, knownUs } = taping();
    box.setOver(true, run());
    box.setOver(false, run());
    pass(100);
    expect(knownUs()).toBe(-1);
  });
});

describe('the tape of a run at full speed', () => {
  it('has one moment in two seconds, and says since when the others are missing', () => {
    const { box, pass, run, timesUs, thin } = taping();
    pass(10);
    box.setThin(true);
    pass(250);
    box.setThin(false);
    pass(2);
    box.tellAll(run());
    const whole = Array.from({ length: 10 }, (_, n) => (n + 1) * 20_000);
    expect(timesUs()).toEqual([...whole, 2_200_000, 4_200_000, 5_220_000, 5_240_000]);
    expect(thin).toEqual([null, 200_000, null]);
  });

  it('has its last moment when it is asked for', () => {
    const { box, pass, run, timesUs, thin } = taping();
    box.setThin(true);
    pass(110);
    box.tellAll(run());
    expect(timesUs()).toEqual([20_000, 2_020_000, 2_200_000]);
    expect(thin).toEqual([-1]);
  });

  it('misses nothing of what came before it was asked for while it stood still', () => {
    const { box, pass, run, thin } = taping();
    box.setThin(true);
    pass(3);
    box.setThin(false);
    box.tellAll(run());
    box.setThin(true);
    pass(60);
    box.tellAll(run());
    expect(thin.at(-1)).toBe(60_000);
  });

  it('can be read without what came before, once it was asked for', () => {
    const { box, pass, run, pieces } = taping();
    box.setThin(true);
    pass(1);
    box.tellAll(run());
    box.setThin(false);
    pass(1);
    box.tellAll(run());
    const [, later] = pieces;
    const alone = new Rows<Snapshot>();
    alone.push(later!);
    expect(alone.at(40_000)).toEqual({ timeUs: 40_000 });
  });
});

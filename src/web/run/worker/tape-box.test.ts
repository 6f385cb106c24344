import { describe, expect, it } from 'vitest';

import type { Snapshot } from '#simulation/snapshot';
import { Rows } from '#tape/rows/rows';
import type { FromWorker } from './protocol';
import { TapeBox } from './tape-box';

/** A box, and how far the page knows the run. */
function taping() {
  const rows = new Rows<Snapshot>();
  let pieces = 0;
  const box = new TapeBox((message: FromWorker) => {
    if (message.type !== 'tape') return;
    pieces += 1;
    expect(rows.push(message.piece)).not.toBeNull();
  });
  let timeUs = 0;
  /** Lets so many moments of 20 ms pass. */
  const pass = (moments: number): void => {
    for (let n = 0; n < moments; n++) box.moment({ timeUs: (timeUs += 20_000) } as Snapshot);
    box.tell();
  };
  return { box, pass, knownUs: () => rows.endUs, pieces: () => pieces };
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
    const { box, pass, knownUs, pieces } = taping();
    pass(30);
    box.setOver(true);
    expect(knownUs()).toBe(600_000);
    pass(49);
    expect(knownUs()).toBe(600_000);
    pass(1);
    expect(knownUs()).toBe(1_600_000);
    expect(pieces()).toBe(2);
  });

  it('goes on in long pieces when a program begins anew', () => {
    const { box, pass, knownUs } = taping();
    box.setOver(true);
    box.setOver(false);
    pass(100);
    expect(knownUs()).toBe(-1);
  });
});

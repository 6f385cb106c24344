import { describe, expect, it } from 'vitest';
import type { PlacedBlock } from '../model/arena-model';
import { createRestSplitter } from './use-blocks-layer';

const block = (id: string, xMm = 0): PlacedBlock => ({
  id,
  pose: { xMm, yMm: 0, headingRad: 0 },
  sizeMm: { x: 50, y: 50 },
});

describe('many blocks', () => {
  it('are parted: one that is pushed is painted anew each time, the others lie', () => {
    const parted = createRestSplitter();
    expect(parted([block('a'), block('b')])).toMatchObject({ still: [{ id: 'a' }, { id: 'b' }], restless: [] });
    const { still, restless } = parted([block('a'), block('b', 5)]);
    expect([still.map(({ id }) => id), restless.map(({ id }) => id)]).toEqual([['a'], ['b']]);
  });

  it('all lie again when nothing has moved for 30 pictures', () => {
    const parted = createRestSplitter();
    parted([block('a')]);
    parted([block('a', 5)]);
    for (let i = 0; i < 30; i += 1) expect(parted([block('a', 5)]).restless).toHaveLength(1);
    expect(parted([block('a', 5)]).restless).toHaveLength(0);
  });
});

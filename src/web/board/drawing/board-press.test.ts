import { describe, expect, it } from 'vitest';

import { slownessOf } from './board-press';

describe('how long a tap lasts', () => {
  it('is 4 times as long at a quarter of the speed, and as usual at 1, 8 and full speed', () => {
    expect(
      [0.25, 0.5, 1, 8, 'max' as const].map((speed) => slownessOf(speed as Parameters<typeof slownessOf>[0])),
    ).toEqual([4, 2, 1, 1, 1]);
  });
});

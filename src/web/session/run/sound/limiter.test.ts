import { describe, expect, it } from 'vitest';

import { limited } from './limiter';

describe('the limiter of the sound', () => {
  it('leaves one source alone as it is', () => {
    for (const value of [0, 0.4, -0.4, 0.6, -0.7]) expect(limited(value)).toBe(value);
  });

  it('keeps several at once below 1, the louder the louder', () => {
    const sums = [0.7, 0.8, 1, 1.3, 2, 4];
    const heard = sums.map(limited);
    expect(Math.max(...heard)).toBeLessThanOrEqual(1);
    expect(heard).toEqual([...heard].sort((one, other) => one - other));
    expect(limited(-1.3)).toBe(-limited(1.3));
  });
});

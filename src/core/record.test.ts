import { describe, expect, it } from 'vitest';

import { isRecord } from './record';

describe('what comes from outside', () => {
  it('has fields by name where it is an object, and else not', () => {
    expect([{}, { a: 1 }].every(isRecord)).toBe(true);
    expect([null, undefined, [], [{}], 'a', 1, () => 1].some(isRecord)).toBe(false);
  });
});

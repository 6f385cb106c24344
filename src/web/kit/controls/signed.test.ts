import { describe, expect, it } from 'vitest';

import { signed } from './signed';

describe('a number for people', () => {
  it('has the minus sign U+2212: −1024, and none at 0 and 21', () => {
    expect(signed(-1024)).toBe('\u22121024');
    expect([signed(0), signed(21)]).toEqual(['0', '21']);
  });
});

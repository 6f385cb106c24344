import { describe, expect, it } from 'vitest';

import { clockText } from './use-run-text';

describe('the clock of the run', () => {
  it('shows minutes, seconds and tenths: 102.67 s are 01:42.6', () => {
    expect(clockText(102_670_000)).toBe('01:42.6');
  });

  it('shows hundredths while paused, so that one step of 20 ms is seen: 00:00.02', () => {
    expect(clockText(20_000, true)).toBe('00:00.02');
    expect(clockText(3_000_000, true)).toBe('00:03.00');
  });
});

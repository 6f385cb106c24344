import { describe, expect, it } from 'vitest';

import { reasonCodes, type CheckResult, type ReasonCode } from '../result';
import { blocksFor, withBlock } from './blocks';

const resultWith = (...codes: readonly ReasonCode[]): CheckResult => ({
  ...{ passed: codes.length === 0, points: 0, stars: null, worlds: [], remarks: [], twin: '' },
  checks: codes.map((code, place) => ({ id: String(place), passed: false, reason: { code, params: {} } })),
});

describe('the ready sentences for a note', () => {
  it('are one for each kind of what does not hold, and praise where all holds', () => {
    expect(blocksFor(resultWith('touched', 'touches', 'loop'))).toEqual(['touch', 'loop']);
    expect(blocksFor(resultWith())).toEqual(['good']);
    expect(blocksFor(resultWith('refused'))).toEqual([]);
  });

  it('know every reason', () => {
    for (const code of reasonCodes) expect(blocksFor(resultWith(code)).length).toBeLessThanOrEqual(1);
  });

  it('are added behind the note, each once', () => {
    const once = withBlock('Fast! ', 'Fahr langsamer.');
    expect(once).toBe('Fast! Fahr langsamer.');
    expect(withBlock(once, 'Fahr langsamer.')).toBe(once);
    expect(withBlock('', 'Gut.')).toBe('Gut.');
  });
});

import { describe, expect, it } from 'vitest';
import { signedDuty } from './dc-motor';

describe('a motor driver', () => {
  it('drives forward all the time for direction 0 and byte 255', () => expect(signedDuty(0, 255)).toBe(1));

  it('drives backward 20 % of the time for direction 1 and byte 51', () => expect(signedDuty(1, 51)).toBe(-0.2));

  it('stops for byte 0 in either direction', () => {
    expect(Object.is(signedDuty(0, 0), 0)).toBe(true);
    expect(Object.is(signedDuty(1, 0), 0)).toBe(true);
  });

  it('takes any other direction byte for backward', () => expect(signedDuty(2, 255)).toBe(-1));
});

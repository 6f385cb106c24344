import { describe, expect, it } from 'vitest';
import { motorLook } from './motor-look';

describe('the wheel on a motor output', () => {
  it('turns 1.5 times a second at full duty and stands still at 0', () => {
    expect(motorLook(1)).toEqual({ direction: 'forwards', turnsPerSecond: 1.5, percent: '100 %' });
    expect(motorLook(0)).toEqual({ direction: 'still', turnsPerSecond: 0, percent: '0 %' });
  });

  it('turns backwards at -0.25, a quarter as fast, and says −25 %', () => {
    expect(motorLook(-0.25)).toEqual({ direction: 'backwards', turnsPerSecond: -0.375, percent: '−25 %' });
  });

  it('says 60 % at 614 of 1023', () => {
    expect(motorLook(614 / 1023).percent).toBe('60 %');
  });

  it('takes 1.7 for 1 and has no −0 %', () => {
    expect(motorLook(1.7).turnsPerSecond).toBe(1.5);
    expect(motorLook(-0.001).percent).toBe('0 %');
    expect(motorLook(-0.001).direction).toBe('backwards');
  });
});

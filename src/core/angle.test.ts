import { describe, expect, it } from 'vitest';
import { degOf, fullTurnDeg, radOf, rotationRad, wrappedDeg } from './angle';

describe('an angle', () => {
  it('of half a turn equals 180° or π', () => {
    expect(degOf(Math.PI)).toBe(180);
    expect(radOf(180)).toBe(Math.PI);
  });

  it('is wrapped to more than −180° up to 180°, exactly', () => {
    const cases = [0, -0, 180, -180, 181, -181, 270, 359.5, 360, -360, 540, 720.25, -1000];
    expect(cases.map(wrappedDeg)).toEqual([0, 0, 180, 180, -179, 179, -90, -0.5, 0, 0, 180, 0.25, 80]);
  });

  it('is brought to 0° up to but without 360°, exactly', () => {
    expect([0, -0, 360, -90, 359.9, 725.5].map(fullTurnDeg)).toEqual([0, 0, 0, 270, 359.9, 5.5]);
  });

  it('keeps the very bits that it had before there were degrees, if it is in eighths of a turn', () => {
    for (let eighths = 0; eighths < 8; eighths++) expect(rotationRad(45 * eighths)).toBe((eighths * Math.PI) / 4);
    expect(rotationRad(30)).toBeCloseTo(Math.PI / 6, 15);
  });
});

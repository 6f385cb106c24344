import { describe, expect, it } from 'vitest';
import { readLightWishes, usualForm } from './light-wish';

describe('the form of a chain of lights', () => {
  it('is a ring for 8, 12, 16 and 24 lights, a 16 × 16 matrix for 256, else a strip', () => {
    expect([8, 12, 16, 24].map(usualForm)).toEqual(['ring', 'ring', 'ring', 'ring']);
    expect(usualForm(256)).toBe('zigzag');
    expect([1, 4, 10, 30, 60, 64, 144, 1024].map(usualForm)).toEqual(Array(8).fill('strip'));
  });
});

describe('stored choices about lights', () => {
  it('are read back, and what makes no sense is left out', () => {
    expect(
      readLightWishes({ P2: { form: 'matrix', place: 'robot' }, P0: { form: 'star', place: 3 }, '<b>': {} }),
    ).toEqual({ P2: { form: 'matrix', place: 'robot' }, P0: {} });
    expect(readLightWishes(null)).toEqual({});
    expect(readLightWishes('x')).toEqual({});
  });
});

import { describe, expect, it } from 'vitest';
import { measureText } from './reading-text';

describe('what the ruler says', () => {
  it('is length and angle, then the place of its end, in cm', () => {
    expect(measureText({ x: 100, y: 100 }, { x: 400, y: 400 })).toBe('42.4 cm · 45° · x 40.0 · y 40.0 cm');
    expect(measureText({ x: 400, y: 100 }, { x: 100, y: 100 })).toBe('30.0 cm · 180° · x 10.0 · y 10.0 cm');
    expect(measureText({ x: 0, y: 100 }, { x: 0, y: 0 })).toBe('10.0 cm · −90° · x 0.0 · y 0.0 cm');
  });

  it('is the place alone after a tap', () => {
    expect(measureText({ x: 123.4, y: 56 }, { x: 123.4, y: 56 })).toBe('x 12.3 · y 5.6 cm');
  });
});

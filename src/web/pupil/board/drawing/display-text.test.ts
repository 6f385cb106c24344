import { describe, expect, it } from 'vitest';
import { displayText } from './display-text';

describe('the display as text', () => {
  it('is 5 rows of 5 digits, so that a screen reader names each light', () => {
    const levels = [0, 9, 0, 9, 0, 0, 0, 0, 0, 0, 0, 0, 5, 0, 0, 9, 0, 0, 0, 9, 0, 9, 9, 9, 0];
    expect(displayText(levels)).toBe('0 9 0 9 0, 0 0 0 0 0, 0 0 5 0 0, 9 0 0 0 9, 0 9 9 9 0');
  });

  it('is all 0 for a board without power, which has no levels', () => {
    expect(displayText([])).toBe('0 0 0 0 0, 0 0 0 0 0, 0 0 0 0 0, 0 0 0 0 0, 0 0 0 0 0');
  });
});

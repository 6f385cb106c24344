import { describe, expect, it } from 'vitest';

import { paletteForm } from './use-palette-form';

describe('the form of the palette', () => {
  it('is one row below the arena where a window has no bench', () =>
    expect(paletteForm('narrow', { widthPx: 800, heightPx: 440 })).toBe('row'));
  it('is two rows on a phone, and stands beside the arena when the phone is held across', () => {
    expect(paletteForm('phone', { widthPx: 390, heightPx: 480 })).toBe('strip');
    expect(paletteForm('phone', { widthPx: 844, heightPx: 280 })).toBe('pairs');
    expect(paletteForm('phone', { widthPx: 844, heightPx: 190 })).toBe('threes');
  });
});

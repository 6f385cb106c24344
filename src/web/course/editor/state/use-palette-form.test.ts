import { describe, expect, it } from 'vitest';

import { paletteForm } from './use-palette-form';

describe('the form of the palette', () => {
  it('shows names in a column where that is high enough for twelve tools, and the course has room beside it', () => {
    expect(paletteForm('wide', { widthPx: 758, heightPx: 552 })).toBe('words');
    expect(paletteForm('wide', { widthPx: 748, heightPx: 552 })).toBe('icons');
  });
  it('takes two columns where one would be too high, so that no tool is out of sight', () => {
    expect(paletteForm('wide', { widthPx: 650, heightPx: 300 })).toBe('pairs');
    expect(paletteForm('narrow', { widthPx: 800, heightPx: 440 })).toBe('pairs');
  });
  it('takes two columns on a tablet, too, where the arena is narrow', () =>
    expect(paletteForm('medium', { widthPx: 400, heightPx: 420 })).toBe('pairs'));
  it('takes as many columns as it needs in a low frame: three for four rows, four for three', () => {
    expect(paletteForm('medium', { widthPx: 500, heightPx: 200 })).toBe('threes');
    expect(paletteForm('medium', { widthPx: 500, heightPx: 150 })).toBe('fours');
  });
  it('is two rows on a phone, and stands beside the arena when the phone is held across', () => {
    expect(paletteForm('phone', { widthPx: 390, heightPx: 480 })).toBe('strip');
    expect(paletteForm('phone', { widthPx: 844, heightPx: 280 })).toBe('pairs');
    expect(paletteForm('phone', { widthPx: 844, heightPx: 190 })).toBe('threes');
  });
});

import { describe, expect, it } from 'vitest';

import { LANGUAGES } from '#core/languages';
import { dateText, decimalSign, numberText, readNumber } from './number-text';

describe('a number in a language', () => {
  it('has a comma in French and a point in the other three, as they are written in Switzerland', () => {
    expect(LANGUAGES.map((language) => numberText(1.5, language))).toEqual(['1.5', '1,5', '1.5', '1.5']);
    expect(LANGUAGES.map(decimalSign)).toEqual(['.', ',', '.', '.']);
  });

  it('has as many decimals as it needs, at most three, or as many as are asked for', () => {
    expect(numberText(12, 'fr')).toBe('12');
    expect(numberText(1 / 3, 'fr')).toBe('0,333');
    expect(numberText(12, 'fr', 1)).toBe('12,0');
    expect(numberText(0.66, 'de', 1)).toBe('0.7');
  });

  it('has no marks for thousands, and never a minus before 0', () => {
    for (const language of LANGUAGES) expect(numberText(1234567, language)).toBe('1234567');
    expect(numberText(-0, 'de')).toBe('0');
  });
});

describe('a number that is typed', () => {
  it('may have a comma or a point: 1,5 and 1.5 are the same', () => {
    expect(readNumber('1,5')).toBe(1.5);
    expect(readNumber(' 1.5 ')).toBe(1.5);
  });

  it('is read back as it is shown, in every language', () => {
    for (const language of LANGUAGES) expect(readNumber(numberText(-12.25, language))).toBe(-12.25);
    expect(readNumber('−3')).toBe(-3);
  });

  it('is none where there is a word or nothing', () => {
    for (const text of ['', ' ', 'drei', '1,2,3', '1e999']) expect(readNumber(text), text).toBeNull();
  });
});

describe('a date', () => {
  it('names day, year and time in every language', () => {
    const atMs = new Date(2026, 10, 21, 23, 4).getTime();
    for (const language of LANGUAGES) expect(dateText(atMs, language)).toMatch(/21.*2026.*23.04/);
  });
});

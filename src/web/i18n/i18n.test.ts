import { describe, expect, it } from 'vitest';

import { de } from './de';
import { en } from './en';
import { errorDe } from './error-de';
import { errorEn } from './error-en';

function leaves(tree: object, path = ''): [string, string][] {
  return Object.entries(tree).flatMap(([key, value]) =>
    typeof value === 'string' ? [[path + key, value] as [string, string]] : leaves(value as object, `${path}${key}.`),
  );
}
const slots = (text: string): string[] => (text.match(/\{\w+\}/g) ?? []).sort();

describe('the catalogues', () => {
  const german = leaves({ ...de, late: errorDe });
  const english = new Map(leaves({ ...en, late: errorEn }));

  it('have the same keys in the same order in German and English', () => {
    expect([...english.keys()]).toEqual(german.map(([key]) => key));
  });

  it('leave the same places open for values', () => {
    for (const [key, text] of german) expect(slots(english.get(key)!), key).toEqual(slots(text));
  });

  it('hold no empty text', () => {
    for (const [key, text] of [...german, ...english]) expect(text.trim(), key).not.toBe('');
  });

  it('spell German the Swiss way, without ß', () => {
    for (const [key, text] of german) expect(text, key).not.toContain('ß');
  });

  it('avoid the signs that vue-i18n reads as its own: @ and a plural bar', () => {
    for (const [key, text] of [...german, ...english]) {
      expect(text, key).not.toMatch(/[@|]/);
    }
  });
});

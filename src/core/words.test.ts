import { describe, expect, it } from 'vitest';

import { byLanguage, inEvery, wordsOf } from './words';

const files = {
  './words/de.json': { title: 'Wand', kinds: { block: 'Block' } },
  './words/en.json': { title: 'Wall', kinds: { block: 'block' } },
  './words/fr.json': { title: 'Mur', kinds: { block: 'bloc' } },
  './words/it.json': { title: 'Muro', kinds: { block: 'blocco' } },
};

describe('the words of a part', () => {
  it('are its texts in every language, named as in its files', () => {
    const words = wordsOf(files);
    expect(words.title).toEqual({ de: 'Wand', fr: 'Mur', it: 'Muro', en: 'Wall' });
    expect(words.kinds.block).toEqual({ de: 'Block', fr: 'bloc', it: 'blocco', en: 'block' });
  });

  it('are found by the language that a file is named after', () => {
    expect(byLanguage(files).it.title).toBe('Muro');
    expect(Object.keys(byLanguage(files))).toEqual(['de', 'fr', 'it', 'en']);
  });

  it('may be the same in every language: Servo S1', () => {
    expect(inEvery(() => 'Servo S1')).toEqual({ de: 'Servo S1', fr: 'Servo S1', it: 'Servo S1', en: 'Servo S1' });
  });
});

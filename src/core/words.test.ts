import { describe, expect, it } from 'vitest';

import { byLanguage, inEvery } from './words';

const files = {
  './words/de.json': { title: 'Wand', kinds: { block: 'Block' } },
  './words/en.json': { title: 'Wall', kinds: { block: 'block' } },
  './words/fr.json': { title: 'Mur', kinds: { block: 'bloc' } },
  './words/it.json': { title: 'Muro', kinds: { block: 'blocco' } },
};

describe('the words of a part', () => {
  it('are found by the language that a file is named after', () => {
    expect(byLanguage(files).it.title).toBe('Muro');
    expect(Object.keys(byLanguage(files))).toEqual(['de', 'fr', 'it', 'en']);
  });

  it('may be the same in every language: Servo S1', () => {
    expect(inEvery(() => 'Servo S1')).toEqual({ de: 'Servo S1', fr: 'Servo S1', it: 'Servo S1', en: 'Servo S1' });
  });
});

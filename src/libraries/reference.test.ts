import { describe, expect, it } from 'vitest';
import { inEvery } from '#core/words';
import { namesOf } from '#python/scopes';
import { readPython } from '#python/tree';
import { mistakesIn } from '#reference/testing/catalogues';
import { textKeysOf } from '#reference/text-keys';
import { textsOfRobot } from '#reference/texts';
import { freeLibraries } from './index';
import { freeReference } from './reference';

/** A library's own functions, classes and variables. */
function publicNames(source: string): string[] {
  const { root } = namesOf(readPython(source));
  const own = root.names.filter(({ binding }) => binding.kind !== 'import');
  return [...new Set(own.map(({ name }) => name))].filter((name) => !name.startsWith('_')).sort();
}

describe('the reference of the libraries that belong to no robot', () => {
  it.each(Object.entries(freeLibraries))('knows every name of %s and no other', (file, source) => {
    const module = freeReference.modules.find(({ name }) => `${name}.py` === file);
    expect(Object.keys(module?.names ?? {}).sort()).toEqual(publicNames(source));
  });

  it('has words for every name, each ending in a full stop, and no more words', () => {
    expect(Object.keys(freeReference.texts).sort()).toEqual([...textKeysOf(freeReference.modules)].sort());
    for (const texts of Object.values(freeReference.texts))
      for (const text of Object.values(texts)) expect(text).toMatch(/\.$/);
  });

  it('says the same in German, French, Italian and English, with the same names and numbers', () => {
    expect(mistakesIn(inEvery((language) => textsOfRobot(freeReference, language)))).toEqual([]);
  });
});

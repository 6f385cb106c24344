import { describe, expect, it } from 'vitest';
import { inEvery } from '#core/words';
import { namesOf } from '#python/scopes';
import { readPython } from '#python/tree';
import { mistakesIn } from '#reference/testing/catalogues';
import { textKeysOf } from '#reference/text-keys';
import { textsOfRobot } from '#reference/texts';
import type { ReferenceModule } from '#reference/types';
import { robotBuilds } from './builds';
import { robotReferences } from './references';

/** The public names of a library: its own functions, classes and variables, without its imports. */
function publicNames(source: string): string[] {
  const { root } = namesOf(readPython(source));
  const own = root.names.filter(({ binding }) => binding.kind !== 'import');
  return [...new Set(own.map(({ name }) => name))].filter((name) => !name.startsWith('_')).sort();
}

/** All names by which programs import a module. */
const namesOfModule = ({ name, aliases }: ReferenceModule): readonly string[] => [name, ...aliases];

describe.each(robotBuilds)('the reference of $type.name', ({ type, libraries }) => {
  const reference = robotReferences.find(({ robot }) => robot === type.id);

  it.each(Object.entries(libraries))('knows every name of %s and no other', (file, source) => {
    const module = reference?.modules.find((it) => namesOfModule(it).some((name) => `${name}.py` === file));
    expect(Object.keys(module?.names ?? {}).sort()).toEqual(publicNames(source));
  });

  it('describes no module that the robot does not bring along', () => {
    const described = reference?.modules.flatMap(namesOfModule).map((name) => `${name}.py`);
    expect(described?.sort()).toEqual(Object.keys(libraries).sort());
  });

  it('has words for every name, each ending in a full stop, and no more words', () => {
    const keys = [...textKeysOf(reference!.modules)].sort();
    expect(Object.keys(reference!.texts).sort()).toEqual(keys);
    for (const texts of Object.values(reference!.texts))
      for (const text of Object.values(texts)) expect(text).toMatch(/\.$/);
  });

  it('says the same in German, French, Italian and English, with the same names and numbers', () => {
    expect(mistakesIn(inEvery((language) => textsOfRobot(reference!, language)))).toEqual([]);
  });
});

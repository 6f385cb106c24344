import { describe, expect, it } from 'vitest';
import { robotBuilds } from '#robots/builds';
import { freeLibraries } from '#libraries/index';
import { smallerPython } from '#python/smaller';
import { readPython } from '#python/tree';
import { filesForDevice } from './device-files';
import { fittingFiles } from './fitting-files';

const main = [{ name: 'main.py', text: 'from simrobot import *\nforward()  # on\n' }];
const libraries = Object.entries(Object.assign({}, freeLibraries, ...robotBuilds.map(({ libraries: own }) => own)) as Record<string, string>); // prettier-ignore

/** The words of a program in their order, without those that say nothing to Python. */
function wordsOf(text: string): readonly string[] {
  const words: string[] = [];
  readPython(text).tree.iterate({
    enter: ({ name, from, to, node }) => {
      if (name === 'Comment') return false;
      if (name !== 'String' && node.firstChild !== null) return true;
      if (to > from) words.push(text.slice(from, to));
      return false;
    },
  });
  return words;
}

describe('the files of a program on a board with little room', () => {
  it('are as they are when they fit', () => {
    expect(fittingFiles(main, 'maqueen-plus-v2', 30_000)).toEqual({ ...filesForDevice(main, 'maqueen-plus-v2'), smaller: [] }); // prettier-ignore
  });

  it('are written in fewer letters when they do not, and only those that are ours', () => {
    const { files, smaller } = fittingFiles(main, 'maqueen-plus-v2', 15_000);
    expect(smaller).toEqual(['simrobot.py', 'mbrobot_plusV2.py']);
    expect(files.at(-1)).toEqual({ ...main[0], isOwn: true });
  });

  it.each(libraries)('%s has the same words in fewer letters', (_, text) => {
    const small = smallerPython(text);
    expect(small.length).toBeLessThan(0.85 * text.length);
    expect(readPython(small).hasErrors).toBe(false);
    // A body of a docstring alone becomes `pass`.
    const said = (words: readonly string[]) => words.filter((word) => !word.startsWith('"""') && word !== 'pass');
    expect(said(wordsOf(small))).toEqual(said(wordsOf(text)));
    expect(smallerPython(small)).toBe(small);
  });
});

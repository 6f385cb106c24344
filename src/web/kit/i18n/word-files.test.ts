import { describe, expect, it } from 'vitest';

import { LANGUAGES } from '#core/languages';
import { inEvery } from '#core/words';

import { openWordFiles, type WordFiles } from './word-files';

/** Files of two groups; what is fetched is noted, and can fail. */
function stage() {
  const fetched: string[] = [];
  const broken = new Set<string>();
  const group = (name: string, parts: readonly (readonly string[])[]): WordFiles[string] =>
    inEvery((language) => () => {
      fetched.push(`${name} ${language}`);
      if (broken.has(`${name} ${language}`)) return Promise.reject(new Error('No connection.'));
      return Promise.resolve({ wordTexts: parts.map((texts) => texts.map((text) => `${text} ${language}`)) });
    });
  const words = openWordFiles({ first: group('first', [['Run', 'Stop'], ['Wall']]), late: group('late', [['Share']]) });
  return { ...words, fetched, broken };
}

describe('the words of the page', () => {
  it('come in one language, and another when it is chosen', async () => {
    const { wordsOfPart, chooseLanguage, fetched } = stage();
    const bar = wordsOfPart('first', 0, { run: 0, more: { stop: 0 } });
    const arena = wordsOfPart('first', 1, { wall: 0 });
    await chooseLanguage('fr');
    expect([bar, arena]).toEqual([
      { run: { fr: 'Run fr' }, more: { stop: { fr: 'Stop fr' } } },
      { wall: { fr: 'Wall fr' } },
    ]);
    await chooseLanguage('it');
    expect(arena).toEqual({ wall: { fr: 'Wall fr', it: 'Wall it' } });
    await chooseLanguage('fr');
    expect(fetched).toEqual(['first fr', 'first it']);
  });

  it('are there when a late part is, in the language that is wanted then', async () => {
    const { wordsOfPart, chooseLanguage, withWords, fetched } = stage();
    wordsOfPart('first', 0, { run: 0 });
    await chooseLanguage('it');
    const load = (): Promise<{ words: unknown }> => Promise.resolve({ words: wordsOfPart('late', 0, { share: 0 }) });
    expect(await withWords(load())).toEqual({ words: { share: { it: 'Share it' } } });
    expect(fetched).toEqual(['first it', 'late it']);
    await chooseLanguage('de');
    expect((await withWords(load())).words).toEqual({ share: { de: 'Share de', it: 'Share it' } });
    expect(fetched).toEqual(['first it', 'late it', 'first de', 'late de']);
  });

  it('keep the part away if they do not come, and are fetched again by the next try', async () => {
    const { wordsOfPart, chooseLanguage, withWords, broken } = stage();
    await chooseLanguage('en');
    broken.add('late en');
    const load = (): Promise<{ words: unknown }> => Promise.resolve({ words: wordsOfPart('late', 0, { share: 0 }) });
    await expect(withWords(load())).rejects.toThrow('No connection.');
    broken.clear();
    expect((await withWords(load())).words).toEqual({ share: { en: 'Share en' } });
  });

  it('are there in the shown language, too, if the part comes while another one is on its way', async () => {
    const { wordsOfPart, chooseLanguage, withWords } = stage();
    wordsOfPart('first', 0, { run: 0 });
    await chooseLanguage('de');
    const choice = chooseLanguage('it');
    const words = await withWords(Promise.resolve(wordsOfPart('late', 0, { share: 0 })));
    expect(words).toEqual({ share: { de: 'Share de', it: 'Share it' } });
    expect(await choice).toBe(true);
  });

  it('stay in the language that is shown where the one that was chosen does not come', async () => {
    const { wordsOfPart, chooseLanguage, withWords, broken } = stage();
    wordsOfPart('first', 0, { run: 0 });
    await chooseLanguage('de');
    for (const group of ['first', 'late']) broken.add(`${group} it`);
    await expect(chooseLanguage('it')).rejects.toThrow('No connection.');
    const load = (): Promise<unknown> => withWords(Promise.resolve(wordsOfPart('late', 0, { share: 0 })));
    expect(await load()).toEqual({ share: { de: 'Share de' } });
    broken.clear();
    expect(await chooseLanguage('it')).toBe(true);
    expect(await load()).toEqual({ share: { de: 'Share de', it: 'Share it' } });
  });

  it('are not to be shown any more where another language was chosen meanwhile', async () => {
    const { chooseLanguage } = stage();
    expect(await Promise.all([chooseLanguage('it'), chooseLanguage('fr')])).toEqual([false, true]);
  });

  it('are in the parts where there are no files: nothing is waited for', async () => {
    const { loadWords, withWords } = openWordFiles({});
    for (const language of LANGUAGES) await loadWords(language);
    expect(await withWords(Promise.resolve({ part: 1 }))).toEqual({ part: 1 });
  });

  it('are waited for by whatever comes late, also by a file that is a text', async () => {
    const { withWords } = stage();
    expect(await withWords(Promise.resolve('<svg/>'))).toBe('<svg/>');
    expect(await withWords(Promise.resolve(null))).toBeNull();
  });
});

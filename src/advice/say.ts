import type { Texts } from '#core/languages';
import { filledIn, inEvery, wordsOf } from '#core/words';
import type { Advice } from './advice';
import type de from './words/de.json';

/** All that can be said about errors of a program, text by text, in every language. */
export const adviceWords = wordsOf(import.meta.glob<typeof de>('./words/*.json', { eager: true, import: 'default' }));

/** An explanation in all languages; `null`: there is none. */
export function adviceTexts({ key, values }: Advice): Texts | null {
  if (key === 'error.other') return null;
  const name = key.slice('error.'.length) as keyof typeof de;
  return inEvery((language) => filledIn(adviceWords[name][language], values));
}

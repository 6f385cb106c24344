import type { Language } from '#core/languages';
import { filledIn, wordsOf } from '#core/words';
import type { Check } from './task';
import type de from './words/de.json';

const words = wordsOf(import.meta.glob<typeof de>('./words/*.json', { eager: true, import: 'default' }));

/** What a check asks, in a few words. */
export function checkText(check: Check, language: Language): string {
  const values = Object.entries(check).filter((entry): entry is [string, string | number] =>
    ['string', 'number'].includes(typeof entry[1]),
  );
  return filledIn(words[check.type][language], Object.fromEntries(values));
}

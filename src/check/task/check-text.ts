import type { Language } from '#core/languages';
import { filledIn, wordsOf } from '#core/words';
import type { Check } from './task';
import type de from './words/de.json';

const words = wordsOf(import.meta.glob<typeof de>('./words/*.json', { eager: true, import: 'default' }));

/** What a check asks, in a few words; a picture is shown beside them (`ledDrawing`). */
export function checkText(check: Check, language: Language): string {
  const values = Object.entries(check).filter((entry): entry is [string, string | number] =>
    ['string', 'number'].includes(typeof entry[1]),
  );
  const name = check.type === 'touches' && check.most === 0 ? 'untouched' : check.type;
  return filledIn(words[name][language], Object.fromEntries(values));
}

import type { Language } from '#core/languages';
import { filledIn } from '#core/words';
import type { Check } from './task';
import words from './words';

/** The requirement of a check, in a few words; a picture is shown beside them (`ledDrawing`). */
export function checkText(check: Check, language: Language): string {
  const values = Object.entries(check).filter((entry): entry is [string, string | number] =>
    ['string', 'number'].includes(typeof entry[1]),
  );
  const name = check.type === 'touches' && check.most === 0 ? 'untouched' : check.type;
  return filledIn(words[name][language], Object.fromEntries(values));
}

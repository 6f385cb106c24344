import type { Language } from '#core/languages';
import { filledIn } from '#core/words';
import type { Check } from './task';
import words from './words';

/** The requirement of a check, in a few words; a picture is shown beside them (`ledDrawing`). */
export function checkText(check: Check, language: Language): string {
  const values = Object.entries(check).filter((entry): entry is [string, string | number] =>
    ['string', 'number'].includes(typeof entry[1]),
  );
  const said = [nameOf(check), ...morePartsOf(check)].map((part) => words[part][language]);
  return filledIn(said.join(', '), Object.fromEntries(values));
}

type Part = Exclude<keyof typeof words, 'languages'>;

const nameOf = (check: Check): Part => (check.type === 'touches' && check.most === 0 ? 'untouched' : check.type);

function morePartsOf(check: Check): readonly Part[] {
  if (check.type === 'checkpoints') return check.each === null ? [] : ['each'];
  if (check.type !== 'stop') return [];
  return [...(check.whole ? (['whole'] as const) : []), ...(check.heading === null ? [] : (['heading'] as const))];
}

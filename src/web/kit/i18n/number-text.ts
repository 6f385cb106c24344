import type { Language } from '#core/languages';

import { memo } from '#core/memo';
import { localeOf } from './locale';

/** Made once each: making one takes far longer than using it, and the first one of a page 10 ms. */
const formatIn = memo((language: Language) =>
  memo((decimals: number | 'any') => {
    const [least, most] = decimals === 'any' ? [0, 3] : [decimals, decimals];
    const digits = { minimumFractionDigits: least, maximumFractionDigits: most };
    return new Intl.NumberFormat(localeOf(language), { useGrouping: false, ...digits });
  }),
);

/**
 * A number as it is written in a language: `1.5` in German-speaking and Italian-speaking Switzerland, `1,5` in
 * French-speaking. Without marks for thousands, which would differ and which nothing here is large enough for.
 *
 * @param decimals exactly this many; left out: as many as the number has, at most three
 */
export function numberText(value: number, language: Language, decimals?: number): string {
  if ((decimals ?? 0) === 0 && Number.isSafeInteger(value) && value >= 0) return String(value); // the same in all of them
  return formatIn(language)(decimals ?? 'any').format(value + 0); // + 0 makes −0 a 0
}

/** The decimal sign; clocks need it with every picture. */
export const decimalSign = memo((language: Language) => numberText(0.5, language, 1).charAt(1));

/** A day and a time of day, as they are written in a language: `21.11.2026, 23:04`. */
export const dateText = (atMs: number, language: Language): string =>
  new Date(atMs).toLocaleString(localeOf(language), { dateStyle: 'medium', timeStyle: 'short' });

/** Parses a typed number, with a point or a comma and either minus sign; `null` for anything else. */
export function readNumber(text: string): number | null {
  const plain = text.trim().replace(',', '.').replace('\u2212', '-');
  const value = Number(plain);
  return plain !== '' && Number.isFinite(value) ? value : null;
}

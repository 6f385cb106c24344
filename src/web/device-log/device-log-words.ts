import { wordsOf } from '#core/words';
import type de from './words/de.json';

/** The words of the data log, and of a real board's beside it; they come with the first of them. */
export const deviceLogWords = wordsOf(
  import.meta.glob<typeof de>('./words/*.json', { eager: true, import: 'default' }),
);

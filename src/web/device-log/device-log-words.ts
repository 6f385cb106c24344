import { wordsOf } from '#core/words';
import type de from './words/de.json';

/** The words of a real board's log; they come with it. */
export const deviceLogWords = wordsOf(
  import.meta.glob<typeof de>('./words/*.json', { eager: true, import: 'default' }),
);

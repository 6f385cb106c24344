import { wordsOf } from '#core/words';
import type de from './words/de.json';

/** What is said where a task keeps something as it is; it comes with the first such task. */
export const handedOutWords = wordsOf(
  import.meta.glob<typeof de>('./words/*.json', { eager: true, import: 'default' }),
);

import { wordsOf } from '#core/words';
import type de from './words/greeting/de.json';

/** The words of the greeting and of the stages; they come with them. */
export const greetingWords = wordsOf(
  import.meta.glob<typeof de>('./words/greeting/*.json', { eager: true, import: 'default' }),
);

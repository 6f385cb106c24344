import { wordsOf } from '#core/words';
import type de from '../words/verdict/de.json';

/** The words of the verdict bar; they come with it. */
export const verdictWords = wordsOf(
  import.meta.glob<typeof de>('../words/verdict/*.json', { eager: true, import: 'default' }),
);

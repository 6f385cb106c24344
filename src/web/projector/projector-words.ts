import { wordsOf } from '#core/words';
import type de from './words/de.json';

/** The words of the projector view; they come with it. */
export const projectorWords = wordsOf(
  import.meta.glob<typeof de>('./words/*.json', { eager: true, import: 'default' }),
);

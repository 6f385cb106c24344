import { wordsOf } from '#core/words';
import type de from './words/de.json';

/** The words of the way through a series; they come with it. */
export const seriesWayWords = wordsOf(
  import.meta.glob<typeof de>('./words/*.json', { eager: true, import: 'default' }),
);

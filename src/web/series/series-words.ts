import { wordsOf } from '#core/words';
import type de from './words/de.json';

/** The words of the pages that show and make a series; they come with them. */
export const seriesWords = wordsOf(import.meta.glob<typeof de>('./words/*.json', { eager: true, import: 'default' }));

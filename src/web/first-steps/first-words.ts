import { wordsOf } from '#core/words';
import type de from './words/de.json';

/** The words of the tour and of the menu; they come with them. */
export const firstWords = wordsOf(import.meta.glob<typeof de>('./words/*.json', { eager: true, import: 'default' }));

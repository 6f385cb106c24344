import { wordsOf } from '#core/words';
import type de from './words/de.json';

/** The words of the window for pictures and printing; they come with it. */
export const printWords = wordsOf(import.meta.glob<typeof de>('./words/*.json', { eager: true, import: 'default' }));

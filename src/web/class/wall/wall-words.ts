import { wordsOf } from '#core/words';
import type de from './words/de.json';

/** The words of the results wall. */
export const wallWords = wordsOf(import.meta.glob<typeof de>('./words/*.json', { eager: true, import: 'default' }));

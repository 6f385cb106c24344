import { wordsOf } from '#core/words';
import type de from './words/de.json';

/** The words about several devices; they come with the first one. */
export const severalWords = wordsOf(import.meta.glob<typeof de>('./words/*.json', { eager: true, import: 'default' }));

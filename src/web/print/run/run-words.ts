import { wordsOf } from '#core/words';
import type de from './words/de.json';

/** The words about pictures of a run. */
export const runWords = wordsOf(import.meta.glob<typeof de>('./words/*.json', { eager: true, import: 'default' }));

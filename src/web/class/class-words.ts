import { wordsOf } from '#core/words';
import type de from './words/de.json';

/** The words of the page that checks a class; they come with it. */
export const classWords = wordsOf(import.meta.glob<typeof de>('./words/*.json', { eager: true, import: 'default' }));

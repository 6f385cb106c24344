import { wordsOf } from '#core/words';
import type de from './words/de.json';

/** What the keys over the soft keyboard are called; they come with them. */
export const keyWords = wordsOf(import.meta.glob<typeof de>('./words/*.json', { eager: true, import: 'default' }));

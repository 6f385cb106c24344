import { wordsOf } from '#core/words';
import type de from './words/de.json';

/** The words of the page on which a task is made; they come with it. */
export const makerWords = wordsOf(import.meta.glob<typeof de>('./words/*.json', { eager: true, import: 'default' }));

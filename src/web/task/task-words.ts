import { wordsOf } from '#core/words';
import type de from './words/de.json';

/** The words of the task's card; they come with it. */
export const taskWords = wordsOf(import.meta.glob<typeof de>('./words/*.json', { eager: true, import: 'default' }));

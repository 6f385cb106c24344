import { wordsOf } from '#core/words';
import type de from './words/de.json';

/** The words about a task's checks; they come with the first task that has some. */
export const checkedWords = wordsOf(import.meta.glob<typeof de>('./words/*.json', { eager: true, import: 'default' }));

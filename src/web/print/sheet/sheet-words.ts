import { wordsOf } from '#core/words';
import type de from './words/de.json';

/** The words of worksheets; they come with their window. */
export const sheetWords = wordsOf(import.meta.glob<typeof de>('./words/*.json', { eager: true, import: 'default' }));

import { wordsOf } from '#core/words';
import type de from './words/de.json';

/** The words of the debugger; they come when a program stands. */
export const debugWords = wordsOf(import.meta.glob<typeof de>('./words/*.json', { eager: true, import: 'default' }));

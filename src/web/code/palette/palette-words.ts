import { wordsOf } from '#core/words';
import type de from './words/de.json';

/** What the commands are called, and what is said about those that the reference does not know; they come with them. */
export const paletteWords = wordsOf(import.meta.glob<typeof de>('./words/*.json', { eager: true, import: 'default' }));

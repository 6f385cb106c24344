import { wordsOf } from '#core/words';
import type de from './words/de.json';

/** The names of what the arena can show and tell. */
export const showWords = wordsOf(import.meta.glob<typeof de>('./words/*.json', { eager: true, import: 'default' }));

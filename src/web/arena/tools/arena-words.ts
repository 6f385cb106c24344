import { wordsOf } from '#core/words';
import type de from '../words/de.json';

/** The words of the arena; they come with its tools. */
export const arenaWords = wordsOf(import.meta.glob<typeof de>('../words/*.json', { eager: true, import: 'default' }));

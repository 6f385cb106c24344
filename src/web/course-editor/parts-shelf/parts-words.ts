import { wordsOf } from '#core/words';
import type de from './words/de.json';

/** The texts of the shelf of parts; they come with it. */
export const partsWords = wordsOf(import.meta.glob<typeof de>('./words/*.json', { eager: true, import: 'default' }));

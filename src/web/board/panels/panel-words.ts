import { wordsOf } from '#core/words';
import type de from './words/de.json';

/** The words of the panels below the board; they come with them. */
export const panelWords = wordsOf(import.meta.glob<typeof de>('./words/*.json', { eager: true, import: 'default' }));

import { wordsOf } from '#core/words';
import type de from './words/de.json';

/** The words of the dialogs for sharing and opening, and of what happens there; they come late. */
export const shareWords = wordsOf(import.meta.glob<typeof de>('./words/*.json', { eager: true, import: 'default' }));

import { wordsOf } from '#core/words';
import type de from './words/de.json';

/** The words of the answer to *why?*; they come when somebody asks. */
export const whyWords = wordsOf(import.meta.glob<typeof de>('./words/*.json', { eager: true, import: 'default' }));

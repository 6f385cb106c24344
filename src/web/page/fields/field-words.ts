import { wordsOf } from '#core/words';
import type de from './words/de.json';

/** What fields say of what is typed; the words come with the first of them. */
export const fieldWords = wordsOf(import.meta.glob<typeof de>('./words/*.json', { eager: true, import: 'default' }));

import { wordsOf } from '#core/words';
import type de from './words/de.json';

/** What the help in the editor says around the words on names; it comes with them. */
export const helpWords = wordsOf(import.meta.glob<typeof de>('./words/*.json', { eager: true, import: 'default' }));

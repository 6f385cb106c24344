import { wordsOf } from '#core/words';
import type de from './words/de.json';

/** The words about tasks for several robots; they come with the first one. */
export const robotsWords = wordsOf(import.meta.glob<typeof de>('./words/*.json', { eager: true, import: 'default' }));

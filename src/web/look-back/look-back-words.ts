import { wordsOf } from '#core/words';
import type de from './words/de.json';

/** The words about looking back; they come when somebody does. */
export const lookBackWords = wordsOf(import.meta.glob<typeof de>('./words/*.json', { eager: true, import: 'default' }));

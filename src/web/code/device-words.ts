import { wordsOf } from '#core/words';
import type de from './words/de.json';

/** The words about what does not run on the device; they come with the marks. */
export const deviceWords = wordsOf(import.meta.glob<typeof de>('./words/*.json', { eager: true, import: 'default' }));

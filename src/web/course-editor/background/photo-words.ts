import { wordsOf } from '#core/words';
import type de from './words/de.json';

/** The texts around a picture that becomes the floor; loaded with the first one. */
export const photoWords = wordsOf(import.meta.glob<typeof de>('./words/*.json', { eager: true, import: 'default' }));

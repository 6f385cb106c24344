import { wordsOf } from '#core/words';
import type de from './words/de.json';

/** The words about the pupil's own programs of a course. */
export const programWords = wordsOf(import.meta.glob<typeof de>('./words/*.json', { eager: true, import: 'default' }));

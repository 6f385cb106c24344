import { wordsOf } from '#core/words';
import type de from '../words/courses/de.json';

/** The words of the gallery of courses and of their menu; they come with them. */
export const courseGalleryWords = wordsOf(
  import.meta.glob<typeof de>('../words/courses/*.json', { eager: true, import: 'default' }),
);

import { wordsOf } from '#core/words';
import type de from '../words/robots/de.json';

/** The words of the gallery of robots; they come with it. */
export const galleryWords = wordsOf(
  import.meta.glob<typeof de>('../words/robots/*.json', { eager: true, import: 'default' }),
);

import { wordsOf } from '#core/words';
import type de from './editing/de.json';

/**
 * The words of the tools’ options, of the list of objects, of the floor’s picture and of what happened; they come
 * with the first tool that is chosen.
 */
export const editingWords = wordsOf(
  import.meta.glob<typeof de>('./editing/*.json', { eager: true, import: 'default' }),
);

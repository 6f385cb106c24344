import { wordsOf } from '#core/words';
import type de from './/de.json';

/**
 * The words of the editor's tools and bars, and of the kinds of objects; they come with the bars.
 */
export const editorWords = wordsOf(import.meta.glob<typeof de>('.//*.json', { eager: true, import: 'default' }));

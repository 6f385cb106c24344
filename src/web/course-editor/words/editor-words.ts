import { wordsOf } from '#core/words';
import type de from './/de.json';

/**
 * The texts of the editor's tools and bars, and of the kinds of objects; loaded with the bars.
 */
export const editorWords = wordsOf(import.meta.glob<typeof de>('.//*.json', { eager: true, import: 'default' }));

import { wordsOf } from '#core/words';
import type de from './/de.json';

/**
 * Where objects are, and what of them waits for the next start. The tools' own texts are the page's: they are seen at once,
 * in one language.
 */
export const editorWords = wordsOf(import.meta.glob<typeof de>('.//*.json', { eager: true, import: 'default' }));

import { wordsOf } from '#core/words';
import type de from './/de.json';

/**
 * The words of the tools, menus and windows of the editor, and of what is wrong with a course; they come with its
 * bars.
 */
export const editorWords = wordsOf(import.meta.glob<typeof de>('.//*.json', { eager: true, import: 'default' }));

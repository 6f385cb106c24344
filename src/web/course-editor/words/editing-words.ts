import { wordsOf } from '#core/words';
import type de from './editing/de.json';

/**
 * The words of the tools’ options, of the editor's menu and windows, of what is wrong with a course and of what
 * happened; they come when they are needed first.
 */
export const editingWords = wordsOf(
  import.meta.glob<typeof de>('./editing/*.json', { eager: true, import: 'default' }),
);

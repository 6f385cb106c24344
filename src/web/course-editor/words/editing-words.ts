import { wordsOf } from '#core/words';
import type de from './editing/de.json';

/**
 * The texts of the tools' options, of the editor's menu and windows, of problems and announcements; loaded on first
 * use.
 */
export const editingWords = wordsOf(
  import.meta.glob<typeof de>('./editing/*.json', { eager: true, import: 'default' }),
);

import { wordsOf } from '#core/words';
import type de from './lines/de.json';

/** The texts of the ways to draw a line and of what can be done to one; loaded on first use. */
export const lineWords = wordsOf(import.meta.glob<typeof de>('./lines/*.json', { eager: true, import: 'default' }));

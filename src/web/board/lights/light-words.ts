import { wordsOf } from '#core/words';
import type de from '../words/de.json';

/** The words of the chains of lights; they come with them. */
export const lightWords = wordsOf(import.meta.glob<typeof de>('../words/*.json', { eager: true, import: 'default' }));

/** A pin as pupils write it: `2` for the wire `P2`. */
export const pinName = (wire: string): string => wire.replace(/^P(?=\d)/, '');

import { wordsOf } from '#core/words';
import type de from '../words/bar/de.json';

/** Words about new versions and about what a frame does not allow; they come late. */
export const barWords = wordsOf(import.meta.glob<typeof de>('../words/bar/*.json', { eager: true, import: 'default' }));

import { wordsOf } from '#core/words';
import type de from './words/de.json';

/** What the arena tells of the robot. */
export const narrationWords = wordsOf(
  import.meta.glob<typeof de>('./words/*.json', { eager: true, import: 'default' }),
);

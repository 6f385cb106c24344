import { wordsOf } from '#core/words';
import type de from '../words/missions/de.json';

/** The words of the missions; they come with them. */
export const missionWords = wordsOf(
  import.meta.glob<typeof de>('../words/missions/*.json', { eager: true, import: 'default' }),
);

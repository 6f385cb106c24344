import { wordsOf } from '#core/words';
import type de from './words/de.json';

/** The words of the dialog for the real device; they come with it. */
export const realDeviceWords = wordsOf(
  import.meta.glob<typeof de>('./words/*.json', { eager: true, import: 'default' }),
);

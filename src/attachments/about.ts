import { wordsOf } from '#core/words';
import type de from './words/about/de.json';

/** What the angles of each attachment's servo mean. Apart from `options.ts`, as only a run and the gallery need it. */
export const attachmentAbout = wordsOf(
  import.meta.glob<typeof de>('./words/about/*.json', { eager: true, import: 'default' }),
);

import { wordsOf } from '#core/words';
import type de from './kinds/de.json';

/** The names of the kinds of objects, for one of them and for several. */
export const kindNames = wordsOf(import.meta.glob<typeof de>('./kinds/*.json', { eager: true, import: 'default' }));

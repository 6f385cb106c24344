import { wordsOf } from '#core/words';
import type de from './words/de.json';

/** The words of the chart; they come with it. */
export const chartWords = wordsOf(import.meta.glob<typeof de>('./words/*.json', { eager: true, import: 'default' }));

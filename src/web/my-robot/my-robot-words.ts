import { wordsOf } from '#core/words';
import type de from './words/de.json';

/** The words of the page on which a robot is measured; they come with it. */
export const myRobotWords = wordsOf(import.meta.glob<typeof de>('./words/*.json', { eager: true, import: 'default' }));

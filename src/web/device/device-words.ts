import type { Texts } from '#core/languages';
import { wordsOf } from '#core/words';
import type de from './words/de.json';

/** The words of the device panel; they come with it. */
export const deviceWords = wordsOf(import.meta.glob<typeof de>('./words/*.json', { eager: true, import: 'default' }));

/** How real a robot can be, and what that is called. */
export const REALITIES: readonly { readonly value: number; readonly name: Texts }[] = [
  { value: 0, name: deviceWords.realities.ideal },
  { value: 0.25, name: deviceWords.realities.almostNew },
  { value: 0.5, name: deviceWords.realities.wornIn },
  { value: 0.75, name: deviceWords.realities.oftenUsed },
  { value: 1, name: deviceWords.realities.oldSchoolRobot },
];

import type { Texts } from '#core/languages';
import words from './words';

/** The degrees of wear of a robot, 0 … 1, with their names. */
export const REALITIES: readonly { readonly value: number; readonly name: Texts }[] = [
  { value: 0, name: words.realities.ideal },
  { value: 0.25, name: words.realities.almostNew },
  { value: 0.5, name: words.realities.wornIn },
  { value: 0.75, name: words.realities.oftenUsed },
  { value: 1, name: words.realities.oldSchoolRobot },
];

import type { Texts } from '#core/languages';

import { shownLanguage } from '.';
import { filled } from './filled';
import type { TextValues } from './texts';

/**
 * A text that brings its languages along: those of robots and courses, and those of panels that load late. Values go
 * into the braces as in the catalogues.
 */
export const say = (texts: Texts, values: TextValues = {}): string =>
  filled(texts[shownLanguage()], values, shownLanguage());

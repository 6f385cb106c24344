import type { Texts } from '#core/texts';

import { shownLanguage } from '.';
import type { TextValues } from './texts';

/**
 * A text that brings its languages along: those of robots and courses, and those of panels that come late, which
 * nobody waits for when the page opens. Values go into the braces as in the catalogues.
 */
export function say(texts: Texts, values: TextValues = {}): string {
  return texts[shownLanguage()].replace(/\{(\w+)\}/g, (slot, name: string) => String(values[name] ?? slot));
}

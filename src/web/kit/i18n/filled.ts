import type { Language } from '#core/languages';
import { filledIn } from '#core/words';

import { numberText } from './number-text';
import type { TextValues } from './texts';

/** A text with its values in the braces, numbers as the language writes them; braces without a value stay. */
export const filled = (text: string, values: TextValues, language: Language): string =>
  filledIn(text, values, (value, slot) => (typeof value === 'number' ? numberText(value, language) : (value ?? slot)));

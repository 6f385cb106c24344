import { numberText } from './number-text';
import type { Language, TextValues } from './texts';

/** A text with its values in the braces, numbers as the language writes them; braces without a value stay. */
export const filled = (text: string, values: TextValues, language: Language): string =>
  text.replace(/\{(\w+)\}/g, (slot, name: string) => {
    const value = values[name] ?? slot;
    return typeof value === 'number' ? numberText(value, language) : value;
  });

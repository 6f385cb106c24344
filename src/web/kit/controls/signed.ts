import { shownLanguage } from '../i18n';
import { numberText } from '../i18n/number-text';

/** A number as people read it: in their language, and with the minus sign, which is as wide as a plus, instead of the hyphen. */
export const signed = (value: number): string => numberText(value, shownLanguage()).replace('-', '\u2212');

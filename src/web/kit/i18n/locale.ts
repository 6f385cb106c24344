import { languages, type Language } from '#core/languages';

/** The tag of a language as browsers and screen readers know it, and by which numbers and dates are written. */
export const localeOf = (language: Language): string => languages[language].locale;

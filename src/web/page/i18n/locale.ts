import type { Language } from '#core/texts';

const LOCALES: Readonly<Record<Language, string>> = { de: 'de-CH', fr: 'fr-CH', it: 'it-CH', en: 'en-GB' };

/** The tag of a language as browsers and screen readers know it, and by which numbers and dates are written. */
export const localeOf = (language: Language): string => LOCALES[language];

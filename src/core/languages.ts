/**
 * The languages of the app, in the order in which they are offered: each with its own name, and with the tag by which
 * browsers and screen readers know it and by which numbers and dates are written. German is that of Switzerland: `ss`,
 * and *du*. A new language is a line here and a file `words/<language>.json` for every part.
 */
export const languages = {
  de: { name: 'Deutsch', locale: 'de-CH' },
  fr: { name: 'Français', locale: 'fr-CH' },
  it: { name: 'Italiano', locale: 'it-CH' },
  en: { name: 'English', locale: 'en-GB' },
} as const;

/** One of the app's languages. */
export type Language = keyof typeof languages;

/** The languages as their two letters. */
export const LANGUAGES = Object.keys(languages) as readonly Language[];

/** A text in every language of the app. */
export type Texts = Readonly<Record<Language, string>>;

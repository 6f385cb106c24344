/** The languages of the app, as their two letters, in the order in which they are offered. */
export const LANGUAGES = ['de', 'fr', 'it', 'en'] as const;

/** One of the app's languages. German is that of Switzerland: `ss`, and *du*. */
export type Language = (typeof LANGUAGES)[number];

/** A text in every language of the app. A language that misses one does not compile. */
export type Texts = Readonly<Record<Language, string>>;

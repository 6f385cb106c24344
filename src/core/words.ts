import { LANGUAGES, type Language, type Texts } from './languages';

/** A catalogue in all languages: each of its texts is the same text in every language. */
export type Words<T> = T extends string ? Texts : { readonly [K in keyof T]: Words<T[K]> };

/**
 * Files by the language they are named after. A new file is found without being listed anywhere.
 *
 * @param files path → content (or its loader), from `import.meta.glob('./words/*.json')`; `npm run check` makes sure that
 *   no language is missing
 */
export const byLanguage = <T>(files: Readonly<Record<string, T>>): Readonly<Record<Language, T>> =>
  inEvery((language) => Object.entries(files).find(([path]) => path.endsWith(`/${language}.json`))?.[1]) as Record<
    Language,
    T
  >;

/** One value per language. */
export const inEvery = <T>(make: (language: Language) => T): Readonly<Record<Language, T>> =>
  Object.fromEntries(LANGUAGES.map((language) => [language, make(language)])) as Record<Language, T>;

/**
 * A text with its values in the braces.
 *
 * @param write formats a value, or `{name}` where there is none; by default numbers are plain and braces without a
 *   value empty
 */
export const filledIn = (
  text: string,
  values: Readonly<Record<string, string | number>>,
  write: (value: string | number | undefined, slot: string) => string = (value = '') => String(value),
): string => text.replace(/\{(\w+)\}/g, (slot, name: string) => write(values[name], slot));

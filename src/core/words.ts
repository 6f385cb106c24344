import { LANGUAGES, type Language, type Texts } from './languages';

/** A catalogue in all languages: each of its texts is the same text in every language. */
export type Words<T> = T extends string ? Texts : { readonly [K in keyof T]: Words<T[K]> };

type Catalogue = string | { readonly [name: string]: Catalogue };

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

/**
 * The words of a part in all languages, from its catalogues, one per language.
 *
 * @param files from `import.meta.glob('./words/*.json', { eager: true, import: 'default' })`
 */
export const wordsOf = <T extends Catalogue>(files: Readonly<Record<string, T>>): Words<T> =>
  together(byLanguage(files)) as Words<T>;

/** Puts catalogues of the same shape together: a tree of texts in every language. */
function together(catalogues: Readonly<Record<Language, Catalogue>>): Words<Catalogue> {
  const { de } = catalogues;
  if (typeof de === 'string') return catalogues as Texts;
  const inner = (name: string): Words<Catalogue> =>
    together(inEvery((language) => (catalogues[language] as Readonly<Record<string, Catalogue>>)[name] ?? ''));
  return Object.fromEntries(Object.keys(de).map((name) => [name, inner(name)]));
}

/** One value per language. */
export const inEvery = <T>(make: (language: Language) => T): Readonly<Record<Language, T>> =>
  Object.fromEntries(LANGUAGES.map((language) => [language, make(language)])) as Record<Language, T>;

/** A text with its values in the braces; braces without a value are empty. */
export const filledIn = (text: string, values: Readonly<Record<string, string | number>>): string =>
  text.replace(/\{(\w+)\}/g, (_whole, name: string) => String(values[name] ?? ''));

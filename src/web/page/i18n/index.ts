import { shallowRef } from 'vue';

import { byLanguage } from '#core/words';

import { filled } from './filled';
import { localeOf } from './locale';
import { LANGUAGES, type ErrorTexts, type Language, type Texts, type Translate } from './texts';

export { LANGUAGES, type Language, type TextKey, type Texts, type TextValues, type Translate } from './texts';

/** A catalogue with its texts under their whole names: `bar.run`. */
type Flat = Readonly<Record<string, string>>;
type Tree = { readonly [name: string]: string | Tree };

/** The texts of a language, fetched when it is chosen: those of other languages are not loaded. */
const catalogues = byLanguage(import.meta.glob<Texts>('../words/*.json', { import: 'default' }));

/** What goes wrong in programs, by language. */
const errorCatalogues = byLanguage(import.meta.glob<ErrorTexts>('../../../advice/words/*.json', { import: 'default' }));

/** Once errors are to be explained, every language comes with its texts for them. */
let explainsErrors = false;
const errorsIn = new Set<Language>();

const loaded = shallowRef<Partial<Record<Language, Flat>>>({});
const shown = shallowRef<Language>('de');

/** The language that is shown. Read in templates, it is followed when it changes. */
export const shownLanguage = (): Language => shown.value;

/** Shows a language whose texts are loaded, without announcing it to the browser: for `setLanguage`, and for tests. */
export const showLanguage = (language: Language): void => void (shown.value = language);

/** Looks a text up by its typed name. Reads the chosen language, so templates follow when it changes. */
export const t: Translate = (key, values = {}) => filled(loaded.value[shown.value]?.[key] ?? key, values, shown.value);

/** Fetches the texts of a language, once. Rejects without a connection. */
export async function loadTexts(language: Language): Promise<void> {
  if (loaded.value[language] === undefined) add(language, flat(await catalogues[language]()));
  if (explainsErrors) await addErrors(language);
}

/** Fetches the texts for what goes wrong in a program, once, in this and every later language. Rejects without a connection. */
export async function loadErrorTexts(): Promise<void> {
  explainsErrors = true;
  await loadTexts(shown.value);
}

async function addErrors(language: Language): Promise<void> {
  if (errorsIn.has(language)) return;
  add(language, flat({ error: await errorCatalogues[language]() }));
  errorsIn.add(language);
}

function add(language: Language, texts: Flat): void {
  loaded.value = { ...loaded.value, [language]: { ...loaded.value[language], ...texts } };
}

function flat(texts: Tree, before = ''): Flat {
  const entries = Object.entries(texts).flatMap(([name, it]) =>
    typeof it === 'string' ? [[before + name, it]] : Object.entries(flat(it, `${before}${name}.`)),
  );
  return Object.fromEntries(entries) as Flat;
}

/** The language chosen last; its texts may still be loading. */
let wanted: Language = 'de';

/** Chooses the page's language, and announces it to browsers and screen readers. Resolves once its texts are loaded. */
export async function setLanguage(language: Language): Promise<void> {
  wanted = language;
  await loadTexts(language);
  if (wanted !== language) return; // another one was chosen meanwhile
  showLanguage(language);
  document.documentElement.lang = localeOf(language);
}

/** The first of the browser's languages that the app has; German, if none. Swiss German is German. */
export function preferredLanguage(tags: readonly string[]): Language {
  for (const tag of tags) {
    const [name = ''] = tag.toLowerCase().split(/[-_]/);
    const found = name === 'gsw' ? 'de' : LANGUAGES.find((language) => language === name);
    if (found !== undefined) return found;
  }
  return 'de';
}

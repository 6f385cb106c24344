import { shallowRef } from 'vue';

import type { Texts } from '#core/languages';

import words from '../words';
import { filled } from './filled';
import { localeOf } from './locale';
import { LANGUAGES, type Language, type TextKey, type TextValues } from './texts';
import { loadWords, chooseLanguage } from './word-files';

export { LANGUAGES, type Language, type TextKey, type TextValues } from './texts';

type Tree = Texts | { readonly [name: string]: Tree };

/** The texts that have whole names, such as `bar.run`: those of the page, later also those for errors of programs. */
const named = shallowRef<Tree>(words);
const shown = shallowRef<Language>('de');

/** The language that is shown. Read in templates, it is followed when it changes. */
export const shownLanguage = (): Language => shown.value;

/** Shows a language whose texts are loaded, without announcing it to the browser: for `setLanguage`, and for tests. */
export const showLanguage = (language: Language): void => void (shown.value = language);

/**
 * A text in the chosen language. Reads that language, so templates follow when it changes.
 *
 * @param text one of a part's words, of a robot or a course; or the whole name of one of the page's
 * @param values for the braces; numbers are written in the form of the language
 */
export function t(text: TextKey | Texts, values: TextValues = {}): string {
  const language = shown.value;
  if (typeof text !== 'string') return filled(text[language], values, language);
  return filled(textAt(named.value, text)?.[language] ?? text, values, language);
}

function textAt(tree: Tree, name: TextKey): Texts | undefined {
  let at: Tree | undefined = tree;
  for (const step of name.split('.')) at = (at as Readonly<Record<string, Tree | undefined>> | undefined)?.[step];
  return at as Texts | undefined;
}

/** Fetches the texts of a language, once. Rejects without a connection. */
export const loadTexts = loadWords;

/** Fetches the texts for what goes wrong in a program, in this and every later language. Rejects without a connection. */
export async function loadErrorTexts(): Promise<void> {
  const { adviceWords } = await import('#advice/say');
  named.value = { ...words, error: { ...words.error, ...adviceWords } };
}

/**
 * Chooses the page's language, and announces it to browsers and screen readers. Resolves once its texts are loaded; where
 * another one was chosen meanwhile, that one is shown. Rejects without a connection.
 */
export async function setLanguage(language: Language): Promise<void> {
  if (!(await chooseLanguage(language))) return;
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

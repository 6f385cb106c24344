import { createI18n, type I18n, type MessageContext, type MessageFunction } from 'vue-i18n';

import { LANGUAGES, type ErrorTexts, type Language, type Texts, type Translate } from './texts';

export { LANGUAGES, type Language, type TextKey, type Texts, type TextValues, type Translate } from './texts';

/** Texts as vue-i18n takes them without its compiler. */
interface Messages {
  readonly [name: string]: Messages | MessageFunction;
}
type Catalogues = Partial<Record<Language, Messages>>;

/** The texts of a language, fetched when it is chosen: nobody waits for those of another one. */
const catalogues: Readonly<Record<Language, () => Promise<Texts>>> = {
  de: async () => (await import('./de')).de,
  en: async () => (await import('./en')).en,
};

/** What goes wrong in programs, by language. */
const errorCatalogues: Readonly<Record<Language, () => Promise<ErrorTexts>>> = {
  de: async () => (await import('./error-de')).errorDe,
  en: async () => (await import('./error-en')).errorEn,
};
/** Once errors are to be explained, every language comes with its texts for them. */
let explainsErrors = false;
const errorsIn = new Set<Language>();

/** The app's vue-i18n instance; without texts until a language is chosen. */
export const i18n: I18n<Catalogues, Record<string, never>, Record<string, never>, Language, false> = createI18n<
  false,
  { legacy: false; locale: Language; fallbackLocale: Language; messages: Catalogues }
>({
  legacy: false,
  locale: 'de',
  fallbackLocale: 'de',
  messages: {},
});

/** The language that is shown. Read in templates, it is followed when it changes. */
export const shownLanguage = (): Language => i18n.global.locale.value as Language; // only setLanguage sets it

/** Looks a text up by its typed name. Reads the chosen language, so templates follow when it changes. */
export const t: Translate = (key, values) => i18n.global.t(key, values ?? {});

/** Fetches the texts of a language, once. Rejects without a connection. */
export async function loadTexts(language: Language): Promise<void> {
  if (!i18n.global.availableLocales.includes(language))
    i18n.global.setLocaleMessage(language, messagesOf(await catalogues[language]()));
  if (explainsErrors) await addErrors(language);
}

/** Fetches the texts for what goes wrong in a program, once, in this and every later language. Rejects without a connection. */
export async function loadErrorTexts(): Promise<void> {
  explainsErrors = true;
  await loadTexts(shownLanguage());
}

async function addErrors(language: Language): Promise<void> {
  if (errorsIn.has(language)) return;
  const error = messagesOf(await errorCatalogues[language]());
  i18n.global.mergeLocaleMessage(language, { error });
  errorsIn.add(language);
}

/** All that our texts need of vue-i18n's own language is places for values in braces; its compiler is not bundled. */
function messagesOf(texts: Tree): Messages {
  const entries = Object.entries(texts);
  return Object.fromEntries(
    entries.map(([name, it]) => [name, typeof it === 'string' ? messageOf(it) : messagesOf(it)]),
  );
}
type Tree = { readonly [name: string]: string | Tree };

function messageOf(text: string): MessageFunction {
  const parts = text.split(/\{(\w+)\}/);
  if (parts.length === 1) return () => text;
  return (context: MessageContext) =>
    parts.map((part, index) => (index % 2 === 0 ? part : valueOf(context.named(part)))).join('');
}
const valueOf = (value: unknown): string =>
  typeof value === 'string' || typeof value === 'number' ? String(value) : '';

/** The language chosen last; its texts may be under way. */
let wanted: Language = 'de';

/** Chooses the language of the page, and tells browsers and screen readers. Done once its texts are there. */
export async function setLanguage(language: Language): Promise<void> {
  wanted = language;
  await loadTexts(language);
  if (wanted !== language) return; // another one was chosen meanwhile
  i18n.global.locale.value = language;
  document.documentElement.lang = language === 'de' ? 'de-CH' : language;
}

/** The first of the browser's languages that the app has; German, if none. */
export function preferredLanguage(tags: readonly string[]): Language {
  for (const tag of tags) {
    const found = LANGUAGES.find((language) => tag.toLowerCase().startsWith(language));
    if (found !== undefined) return found;
  }
  return 'de';
}

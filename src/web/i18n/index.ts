import { createI18n, type I18n } from 'vue-i18n';

import { de } from './de';
import { en } from './en';
import { LANGUAGES, type Language, type Translate } from './texts';

export { LANGUAGES, type Language, type TextKey, type Texts, type TextValues, type Translate } from './texts';

type Catalogues = Record<Language, typeof en>;

/** The app's vue-i18n instance; German until a language is chosen. */
export const i18n: I18n<Catalogues, Record<string, never>, Record<string, never>, Language, false> = createI18n<
  false,
  { legacy: false; locale: Language; fallbackLocale: Language; messages: Catalogues }
>({ legacy: false, locale: 'de', fallbackLocale: 'de', messages: { de, en } });

/** Looks a text up by its typed name. Reads the chosen language, so templates follow when it changes. */
export const t: Translate = (key, values) => i18n.global.t(key, values ?? {});

/** Chooses the language of the page, and tells browsers and screen readers. */
export function setLanguage(language: Language): void {
  i18n.global.locale.value = language;
  document.documentElement.lang = language === 'de' ? 'de-CH' : language;
}

/** The first of the browser's languages that the app has; German, if none. */
export function preferredLanguage(wanted: readonly string[]): Language {
  for (const tag of wanted) {
    const found = LANGUAGES.find((language) => tag.toLowerCase().startsWith(language));
    if (found !== undefined) return found;
  }
  return 'de';
}

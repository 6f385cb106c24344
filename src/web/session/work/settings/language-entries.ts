import { languages } from '#core/languages';

import type { MenuEntry } from '../../../kit/controls/menu-entry';
import { LANGUAGES } from '../../../kit/i18n';
import type { SettingsModel } from './settings-model';

/** The languages of the page as entries of a menu. */
export const languageEntries = (settings: Pick<SettingsModel, 'current' | 'change'>): readonly MenuEntry<unknown>[] =>
  LANGUAGES.map((language) => ({
    ...{ id: language, lang: language, title: languages[language].name, choice: 'radio' },
    isChosen: language === settings.current.value.language,
    act: () => settings.change({ language }),
  }));

import {
  mdiChip,
  mdiRobotOutline,
  mdiThemeLightDark,
  mdiTranslate,
  mdiVolumeHigh,
  mdiVolumeOff,
  mdiWeatherNight,
  mdiWhiteBalanceSunny,
} from '@mdi/js';
import { languages } from '#core/languages';

import type { Contribution, MenuPart } from '../kit/features/feature';
import { LANGUAGES, t } from '../kit/i18n';
import type { TextKey } from '../kit/i18n/texts';
import { usePage } from '../kit/parts';
import { useLayout } from '../session/layout/parts';
import { useWork, type WorkParts } from '../session/work/model/parts';
import { THEMES, type Theme } from '../session/work/settings/settings';
import { switchSound } from './switches';

const themes: Readonly<Record<Theme, { readonly key: TextKey; readonly icon: string }>> = {
  system: { key: 'bar.themeSystem', icon: mdiThemeLightDark },
  light: { key: 'bar.themeLight', icon: mdiWhiteBalanceSunny },
  dark: { key: 'bar.themeDark', icon: mdiWeatherNight },
};

/** Language and colours. */
const choices = (settings: WorkParts['settings']): readonly MenuPart[] => [
  {
    group: 'choices',
    order: 0,
    heading: () => t('bar.language'),
    entries: () =>
      LANGUAGES.map((language) => ({
        id: language,
        icon: mdiTranslate,
        title: languages[language].name,
        lang: language,
        choice: 'radio',
        isChosen: language === settings.current.value.language,
        act: () => settings.change({ language }),
      })),
  },
  {
    group: 'choices',
    order: 10,
    heading: () => t('bar.theme'),
    entries: () =>
      THEMES.map((theme) => ({
        id: theme,
        icon: themes[theme].icon,
        title: t(themes[theme].key),
        choice: 'radio',
        isChosen: theme === settings.current.value.theme,
        act: () => settings.change({ theme }),
      })),
  },
];

/** Sound, panes, language and colours. */
export const contribution: Contribution = {
  menu() {
    const app = { ...usePage(), ...useWork(), ...useLayout() };
    const { settings, layout } = app;
    const isPhone = (): boolean => layout.kind.value === 'phone';
    return [
      {
        group: 'run',
        order: 10,
        entries() {
          const { muted } = settings.current.value;
          const icon = muted ? mdiVolumeOff : mdiVolumeHigh;
          const title = t(muted ? 'bar.unmute' : 'bar.mute');
          return isPhone() ? [{ id: 'sound', icon, title, act: () => switchSound(app) }] : [];
        },
      },
      {
        group: 'panes',
        order: 0,
        entries() {
          const { showBoard, showArena } = settings.current.value;
          if (isPhone()) return []; // each has a tab
          return [
            {
              id: 'board',
              icon: mdiChip,
              title: t(showBoard ? 'bar.hideBoard' : 'bar.showBoard'),
              act: () => settings.change({ showBoard: !showBoard }),
            },
            {
              id: 'arena',
              icon: mdiRobotOutline,
              title: t(showArena ? 'bar.hideArena' : 'bar.showArena'),
              act: () => settings.change({ showArena: !showArena }),
            },
          ];
        },
      },
      ...choices(settings),
    ];
  },
};

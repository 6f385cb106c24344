import {
  mdiChip,
  mdiEyeOutline,
  mdiRobotOutline,
  mdiThemeLightDark,
  mdiTranslate,
  mdiViewDashboardOutline,
  mdiWeatherNight,
  mdiWhiteBalanceSunny,
} from '@mdi/js';
import { languages } from '#core/languages';

import { tick } from '../kit/controls/tick';
import { listEntry, type Contribution, type MenuPart } from '../kit/features/feature';
import { t } from '../kit/i18n';
import type { TextKey } from '../kit/i18n/texts';
import { useLayout } from '../session/layout/parts';
import { useWork, type WorkParts } from '../session/work/model/parts';
import { languageEntries } from '../session/work/settings/language-entries';
import { THEMES, type Theme } from '../session/work/settings/settings';

const themes: Readonly<Record<Theme, { readonly key: TextKey; readonly icon: string }>> = {
  system: { key: 'bar.themeSystem', icon: mdiThemeLightDark },
  light: { key: 'bar.themeLight', icon: mdiWhiteBalanceSunny },
  dark: { key: 'bar.themeDark', icon: mdiWeatherNight },
};

/** The choices of language and colours. */
const choices = (settings: WorkParts['settings']): readonly MenuPart[] => [
  {
    group: 'language',
    order: 0,
    entries: () => languageEntries(settings).map((entry) => ({ ...entry, icon: mdiTranslate })),
  },
  {
    group: 'theme',
    order: 0,
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

/** The panes that can be put away. */
const panes = (settings: WorkParts['settings']): MenuPart => ({
  group: 'panes',
  order: 0,
  entries() {
    const { showBoard, showArena } = settings.current.value;
    return [
      {
        ...{ id: 'board', testId: 'pane-board', icon: mdiChip, title: t('board.pane') },
        ...tick(showBoard),
        act: () => settings.change({ showBoard: !showBoard }),
      },
      {
        ...{ id: 'arena', testId: 'pane-arena', icon: mdiRobotOutline, title: t('arena.pane') },
        ...tick(showArena),
        act: () => settings.change({ showArena: !showArena }),
      },
    ];
  },
});

/** Language, colours and panes. */
export const contribution: Contribution = {
  menu() {
    const { settings } = useWork();
    const { layout } = useLayout();
    return [
      {
        group: 'view',
        order: 0,
        entries() {
          const { language, theme } = settings.current.value;
          const isPhone = layout.kind.value === 'phone'; // there each pane has a tab
          return [
            listEntry('language', { icon: mdiTranslate, title: t('bar.language'), value: languages[language].name }),
            listEntry('theme', { icon: mdiThemeLightDark, title: t('bar.theme'), value: t(themes[theme].key) }),
            isPhone
              ? listEntry('hints', { icon: mdiEyeOutline, title: t('menu.hints') })
              : listEntry('panes', { icon: mdiViewDashboardOutline, title: t('menu.panes') }),
          ];
        },
      },
      ...choices(settings),
      panes(settings),
    ];
  },
};

import { mdiHelpCircleOutline, mdiKeyboardOutline, mdiWalk } from '@mdi/js';

import type { Contribution } from '../kit/features/feature';
import { t } from '../kit/i18n';
import { useLayout } from '../session/layout/parts';
import { useWork } from '../session/work/model/parts';
import { useFirstSteps } from './parts';
import words from './words';

export const contribution: Contribution = {
  menu() {
    const { guide, tour } = useFirstSteps();
    const { settings } = useWork();
    const { layout } = useLayout();
    return [
      {
        group: 'help',
        order: 0,
        entries() {
          const { startTour, resumeTour, help } = words.stages;
          const tourText = settings.current.value.tourStep === null ? startTour : resumeTour;
          const keys = {
            ...{ id: 'keys', testId: 'menu-keys', icon: mdiKeyboardOutline, title: t('menu.keys') },
            act: (menu: { leaveFor(open: () => void): void }) => menu.leaveFor(() => guide.open('key-run')),
          };
          return [
            {
              ...{ id: 'help', testId: 'menu-help', icon: mdiHelpCircleOutline, title: t(help) },
              ...(layout.kind.value !== 'phone' && { value: 'F1' }),
              act: (menu) => menu.leaveFor(guide.open),
            },
            {
              ...{ id: 'tour', testId: 'menu-tour', icon: mdiWalk, title: t(tourText) },
              act: (menu) => menu.leaveFor(tour.open),
            },
            ...(layout.kind.value === 'phone' ? [] : [keys]),
          ];
        },
      },
    ];
  },
};

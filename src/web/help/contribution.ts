import { mdiHelpCircleOutline, mdiWalk } from '@mdi/js';

import type { Contribution } from '../kit/features/feature';
import { t } from '../kit/i18n';
import { useWork } from '../session/work/model/parts';
import { useFirstSteps } from './parts';
import words from './words';

export const contribution: Contribution = {
  menu() {
    const { guide, tour } = useFirstSteps();
    const { settings } = useWork();
    return [
      {
        group: 'help',
        order: 0,
        entries() {
          const { startTour, resumeTour, help } = words.stages;
          const tourText = settings.current.value.tourStep === null ? startTour : resumeTour;
          return [
            {
              id: 'help',
              testId: 'menu-help',
              icon: mdiHelpCircleOutline,
              title: t(help),
              act: (menu) => menu.leaveFor(guide.open),
            },
            {
              id: 'tour',
              testId: 'menu-tour',
              icon: mdiWalk,
              title: t(tourText),
              act: (menu) => menu.leaveFor(tour.open),
            },
          ];
        },
      },
    ];
  },
};

import { mdiProjectorScreenOutline } from '@mdi/js';

import type { Contribution } from '../../kit/features/feature';
import { t } from '../../kit/i18n';
import { openProjector } from '../../session/layout/open-projector';
import { useLayout } from '../../session/layout/parts';
import showWords from '../../session/layout/words';
import { useVisit } from '../../session/visit/parts';
import { useWork } from '../../session/work/model/parts';
import words from './words';

export const contribution: Contribution = {
  menu() {
    const app = { ...useWork(), ...useLayout() };
    const { host } = useVisit();
    return [
      {
        group: 'pages',
        order: 40,
        entries: () =>
          host.parts.value !== null
            ? []
            : [
                {
                  id: 'projector',
                  testId: 'menu-projector',
                  icon: mdiProjectorScreenOutline,
                  title: t(showWords.projector.title),
                  act: (menu) => menu.leaveFor(() => void openProjector(app)),
                },
              ],
      },
    ];
  },
  help: [
    {
      id: 'projector',
      section: 'menu',
      after: 'class',
      icon: mdiProjectorScreenOutline,
      name: () => t(showWords.projector.title),
      text: () => t(words.help),
      covers: ['menu-projector', 'show-projector', 'projector-open'],
    },
  ],
};

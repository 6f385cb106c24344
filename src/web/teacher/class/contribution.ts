import { mdiClipboardCheckOutline } from '@mdi/js';

import type { Contribution } from '../../kit/features/feature';
import { t } from '../../kit/i18n';
import { useLayout } from '../../session/layout/parts';
import { useVisit } from '../../session/visit/parts';
import words from './words';

export const contribution: Contribution = {
  menu() {
    const { router } = useLayout();
    const { host } = useVisit();
    return [
      {
        group: 'pages',
        order: 30,
        entries: () =>
          host.parts.value !== null
            ? []
            : [
                {
                  id: 'class',
                  testId: 'menu-class',
                  icon: mdiClipboardCheckOutline,
                  title: t(words.title),
                  act: (menu) => menu.leaveFor(() => router.open('class')),
                },
              ],
      },
    ];
  },
  help: [
    {
      id: 'class',
      section: 'menu',
      after: 'series',
      icon: mdiClipboardCheckOutline,
      name: () => t(words.title),
      text: () => t(words.help),
      covers: ['menu-class'],
    },
  ],
};

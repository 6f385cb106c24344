import { mdiClipboardEditOutline } from '@mdi/js';

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
        order: 10,
        entries: () =>
          host.parts.value !== null
            ? []
            : [
                {
                  id: 'task',
                  testId: 'menu-task',
                  icon: mdiClipboardEditOutline,
                  title: t(words.title),
                  act: (menu) => menu.leaveFor(() => router.open('task')),
                },
              ],
      },
    ];
  },
  help: [
    {
      id: 'task-maker',
      section: 'menu',
      after: 'gallery',
      icon: mdiClipboardEditOutline,
      name: () => t(words.title),
      text: () => t(words.help),
      covers: ['menu-task'],
    },
  ],
};

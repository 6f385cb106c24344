import { mdiChip, mdiRobotHappyOutline } from '@mdi/js';

import type { Contribution } from '../../kit/features/feature';
import { t } from '../../kit/i18n';
import { hasLittleRoom } from '../../session/layout/layout-model';
import { useLayout } from '../../session/layout/parts';
import words from './words';

export const contribution: Contribution = {
  menu() {
    const { layout, router } = useLayout();
    const devices = () => import('./DeviceList.vue');
    return [
      {
        group: 'run',
        order: 30,
        entries: () =>
          !hasLittleRoom(layout.kind.value)
            ? []
            : [
                {
                  id: 'device',
                  testId: 'device',
                  icon: mdiChip,
                  title: t('device.choose'),
                  stays: true,
                  act: (menu) => menu.showInside(devices, true),
                },
              ],
      },
      {
        group: 'pages',
        order: 0,
        entries: () => [
          {
            id: 'gallery',
            testId: 'gallery',
            icon: mdiRobotHappyOutline,
            title: t(words.gallery),
            act: (menu) => menu.leaveFor(() => router.open('robots')),
          },
        ],
      },
    ];
  },
};

import { mdiRobotHappyOutline, mdiRobotOutline } from '@mdi/js';

import type { Contribution } from '../../kit/features/feature';
import { t } from '../../kit/i18n';
import { usePage } from '../../kit/parts';
import { useLayout } from '../../session/layout/parts';
import { useRun } from '../../session/run/parts';
import { useWork } from '../../session/work/model/parts';
import { useDeviceName } from './use-device-name';
import words from './words';

/** The chip of the device, for which a phone's bar has no room, and the gallery of robots. */
export const contribution: Contribution = {
  menu() {
    const { layout, router } = useLayout();
    const { name } = useDeviceName({ ...usePage(), ...useRun(), ...useWork() });
    return [
      {
        group: 'run',
        order: 20,
        entries: () =>
          layout.kind.value !== 'phone'
            ? []
            : [
                {
                  ...{ id: 'device', testId: 'device', icon: mdiRobotOutline, title: t('device.title') },
                  ...{ value: name.value, leads: true },
                  act: (menu) => menu.showInside(() => import('./DevicePanel.vue'), true),
                },
              ],
      },
      {
        group: 'help',
        order: 20,
        entries: () => [
          {
            ...{ id: 'gallery', testId: 'gallery', icon: mdiRobotHappyOutline, title: t(words.gallery) },
            act: (menu) => menu.leaveFor(() => router.open('robots')),
          },
        ],
      },
    ];
  },
};

import { mdiUsb } from '@mdi/js';

import type { Contribution } from '../../kit/features/feature';
import { t } from '../../kit/i18n';

export const contribution: Contribution = {
  menu: () => [
    {
      group: 'files',
      order: 20,
      entries: () => [
        {
          id: 'real-device',
          testId: 'menu-real-device',
          icon: mdiUsb,
          title: t('menu.toDevice'),
          act: (menu) => menu.openDialog(() => import('./RealDeviceDialog.vue')),
        },
      ],
    },
  ],
};

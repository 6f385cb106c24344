import { mdiUsb } from '@mdi/js';

import { tick } from '../../kit/controls/tick';
import type { Contribution } from '../../kit/features/feature';
import { t } from '../../kit/i18n';
import { useWork } from '../../session/work/model/parts';

export const contribution: Contribution = {
  menu() {
    const { settings } = useWork();
    return [
      {
        group: 'hints',
        order: 50,
        entries() {
          const { deviceCheck } = settings.current.value;
          return [
            {
              id: 'device-check-switch',
              testId: 'device-check-switch',
              icon: mdiUsb,
              title: t('deviceCheck.setting'),
              ...tick(deviceCheck),
              act: () => settings.change({ deviceCheck: !deviceCheck }),
            },
          ];
        },
      },
    ];
  },
};

import { mdiCheckboxBlankOutline, mdiCheckboxMarkedOutline } from '@mdi/js';

import type { Contribution } from '../../kit/features/feature';
import { t } from '../../kit/i18n';
import { useWork } from '../../session/work/model/parts';

export const contribution: Contribution = {
  menu() {
    const { settings } = useWork();
    return [
      {
        group: 'pages',
        order: 50,
        entries() {
          const { deviceCheck } = settings.current.value;
          return [
            {
              id: 'device-check-switch',
              testId: 'device-check-switch',
              icon: deviceCheck ? mdiCheckboxMarkedOutline : mdiCheckboxBlankOutline,
              title: t('deviceCheck.setting'),
              choice: 'checkbox',
              isChosen: deviceCheck,
              act: () => settings.change({ deviceCheck: !deviceCheck }),
            },
          ];
        },
      },
    ];
  },
};

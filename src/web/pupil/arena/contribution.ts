import { mdiVolumeHigh, mdiVolumeOff } from '@mdi/js';

import type { Contribution } from '../../kit/features/feature';
import { t } from '../../kit/i18n';
import { useLayout } from '../../session/layout/parts';
import { speedName } from '../../session/run/speed-text';
import { useWork } from '../../session/work/model/parts';

/** Speed and sound, for which a phone's bar has no room. */
export const contribution: Contribution = {
  menu() {
    const { layout } = useLayout();
    const { settings } = useWork();
    return [
      {
        group: 'run',
        order: 30,
        entries() {
          if (layout.kind.value !== 'phone') return [];
          const { muted, speed } = settings.current.value;
          return [
            {
              ...{ id: 'speed', testId: 'menu-speed', icon: muted ? mdiVolumeOff : mdiVolumeHigh },
              ...{ title: t('bar.speedAndSound'), value: speedName(speed), leads: true },
              act: (menu) => menu.showInside(() => import('./SpeedList.vue')),
            },
          ];
        },
      },
    ];
  },
};

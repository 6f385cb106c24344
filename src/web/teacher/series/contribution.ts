import { mdiFormatListNumbered } from '@mdi/js';

import type { Contribution } from '../../kit/features/feature';
import { t } from '../../kit/i18n';
import { useLayout } from '../../session/layout/parts';
import { placeOf } from '../../session/task/series/series-place';
import wayWords from '../../session/task/series/words';
import { useWork } from '../../session/work/model/parts';

export const contribution: Contribution = {
  menu() {
    const { work } = useWork();
    const { router } = useLayout();
    return [
      {
        group: 'files',
        order: 30,
        entries() {
          const series = placeOf(work.work.value.project)?.series;
          if (series === undefined) return [];
          return [
            {
              id: 'series',
              testId: 'menu-series',
              icon: mdiFormatListNumbered,
              title: t(wayWords.back),
              act: (menu) => menu.leaveFor(() => router.open('series', series)),
            },
          ];
        },
      },
    ];
  },
};

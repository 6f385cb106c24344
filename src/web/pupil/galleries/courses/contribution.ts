import { mdiMapMarkerPath } from '@mdi/js';

import type { Contribution } from '../../../kit/features/feature';
import { t } from '../../../kit/i18n';
import { useLayout } from '../../../session/layout/parts';

export const contribution: Contribution = {
  menu() {
    const { layout } = useLayout();
    const courses = () => import('./CourseList.vue');
    return [
      {
        group: 'run',
        order: 20,
        entries: () =>
          layout.kind.value !== 'phone'
            ? []
            : [
                {
                  id: 'courses',
                  icon: mdiMapMarkerPath,
                  title: t('bar.course'),
                  stays: true,
                  act: (menu) => menu.showInside(courses),
                },
              ],
      },
    ];
  },
};

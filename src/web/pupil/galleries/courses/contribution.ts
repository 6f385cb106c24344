import { mdiFlagCheckered } from '@mdi/js';

import type { Contribution } from '../../../kit/features/feature';
import { t } from '../../../kit/i18n';
import { useLayout } from '../../../session/layout/parts';
import { courseName } from '../../../session/work/catalogue/first-course';
import { useWork } from '../../../session/work/model/parts';

/** The chip of the task, for which a phone's bar has no room. */
export const contribution: Contribution = {
  menu() {
    const { layout } = useLayout();
    const { work } = useWork();
    return [
      {
        group: 'run',
        order: 10,
        entries: () =>
          layout.kind.value !== 'phone'
            ? []
            : [
                {
                  ...{ id: 'courses', testId: 'menu-course', icon: mdiFlagCheckered, title: t('bar.task') },
                  ...{ value: courseName(work.scene.value, work.work.value.project.course), leads: true },
                  act: (menu) => menu.showInside(() => import('./CourseList.vue')),
                },
              ],
      },
    ];
  },
};

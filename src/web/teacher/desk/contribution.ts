import { mdiSchoolOutline } from '@mdi/js';

import type { Contribution } from '../../kit/features/feature';
import { t } from '../../kit/i18n';
import { useLayout } from '../../session/layout/parts';
import { useVisit } from '../../session/visit/parts';
import { isHandedOut } from '../../session/work/model/task-locks';
import { useWork } from '../../session/work/model/parts';
import { DESK } from './back-to-desk';
import words from './words';

/** The way to the page for teachers; none in a task that was handed out, or where a host chooses what is shown. */
export const contribution: Contribution = {
  menu() {
    const { router } = useLayout();
    const { host } = useVisit();
    const { work } = useWork();
    return [
      {
        group: 'teachers',
        order: 0,
        entries: () =>
          host.parts.value !== null || isHandedOut(work.work.value.project)
            ? []
            : [
                {
                  ...{ id: 'teachers', testId: 'menu-teachers', icon: mdiSchoolOutline },
                  ...{ title: t(words.title), about: t(words.about), leads: true },
                  act: (menu) => menu.leaveFor(() => router.open(DESK)),
                },
              ],
      },
    ];
  },
};

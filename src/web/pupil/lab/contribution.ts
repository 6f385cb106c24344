import { mdiFlaskOutline } from '@mdi/js';

import type { Contribution } from '../../kit/features/feature';
import { t } from '../../kit/i18n';
import { useLayout } from '../../session/layout/parts';
import { useVisit } from '../../session/visit/parts';
import { useWork } from '../../session/work/model/parts';
import { isExam } from '../../session/work/model/task-locks';
import words from './words';

/** The way to the experiments; none where a host chooses what is shown, and in an exam. */
export const contribution: Contribution = {
  menu() {
    const { router } = useLayout();
    const { host } = useVisit();
    const { work } = useWork();
    return [
      {
        group: 'files',
        order: 50,
        entries: () =>
          host.parts.value !== null || isExam(work.work.value.project)
            ? []
            : [
                {
                  ...{ id: 'lab', testId: 'menu-lab', icon: mdiFlaskOutline, title: t(words.title) },
                  act: (menu) => menu.leaveFor(() => router.open('lab')),
                },
              ],
      },
    ];
  },
};

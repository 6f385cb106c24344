import { mdiPrinterOutline } from '@mdi/js';

import { useCourseEditor } from '../../course/editor/state/parts';
import type { Contribution } from '../../kit/features/feature';
import { t } from '../../kit/i18n';
import words from './words';

/** The course as a picture, on paper, or with its task. */
export const contribution: Contribution = {
  menu() {
    const { panels } = useCourseEditor();
    return [
      {
        group: 'save',
        order: 10,
        entries: () => [
          {
            ...{ id: 'print', testId: 'menu-print', icon: mdiPrinterOutline, title: t(words.title) },
            act: (menu) => menu.leaveFor(() => panels.open('print')),
          },
        ],
      },
    ];
  },
};

import { mdiCheckboxBlankOutline, mdiCheckboxMarkedOutline } from '@mdi/js';

import type { Contribution } from '../../kit/features/feature';
import { t } from '../../kit/i18n';
import showWords from '../../session/layout/words';
import { useWork } from '../../session/work/model/parts';

export const contribution: Contribution = {
  menu() {
    const { settings } = useWork();
    return [
      {
        group: 'pages',
        order: 60,
        entries() {
          const { tell } = settings.current.value;
          return [
            {
              id: 'tell-switch',
              testId: 'tell-switch',
              icon: tell ? mdiCheckboxMarkedOutline : mdiCheckboxBlankOutline,
              title: t(showWords.tell.title),
              choice: 'checkbox',
              isChosen: tell,
              act: () => settings.change({ tell: !tell }),
            },
          ];
        },
      },
    ];
  },
};

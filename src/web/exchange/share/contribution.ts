import {
  mdiContentSaveOutline,
  mdiFileCodeOutline,
  mdiFolderOpenOutline,
  mdiMapOutline,
  mdiShareVariant,
  mdiTrayArrowUp,
} from '@mdi/js';

import { listEntry, type Contribution, type FeatureEntry } from '../../kit/features/feature';
import { t } from '../../kit/i18n';
import type { TextKey } from '../../kit/i18n/texts';
import { useLayout } from '../../session/layout/parts';
import { useTask } from '../../session/task/parts';
import { useCommands } from './use-commands';

const entry = (id: string, icon: string, key: TextKey, act: FeatureEntry['act']): FeatureEntry => ({
  ...{ id, testId: `menu-${id}`, icon, title: t(key), act },
});

/** Opening, saving, and on a phone sharing. */
export const contribution: Contribution = {
  menu() {
    const commands = useCommands();
    const { layout } = useLayout();
    const { task } = useTask();
    /** A task that was handed out is handed in. */
    const share = (): FeatureEntry =>
      task.handIn.isAsked.value
        ? entry('hand-in', mdiTrayArrowUp, 'bar.handIn', (menu) => menu.leaveFor(task.handIn.open))
        : entry('share', mdiShareVariant, 'bar.share', (menu) => menu.openDialog(() => import('./ShareDialog.vue')));
    return [
      {
        group: 'files',
        order: 10,
        entries() {
          return [
            ...(layout.kind.value === 'phone' ? [share()] : []),
            entry('open', mdiFolderOpenOutline, 'menu.open', (menu) =>
              menu.openDialog(() => import('./OpenDialog.vue')),
            ),
            listEntry('save', { icon: mdiContentSaveOutline, title: t('menu.save') }),
          ];
        },
      },
      {
        group: 'save',
        order: 0,
        entries: () => [
          { ...entry('save', mdiContentSaveOutline, 'bar.save', commands.save), value: 'Ctrl+S' },
          entry('save-program', mdiFileCodeOutline, 'menu.saveProgram', commands.saveProgram),
          entry('save-scene', mdiMapOutline, 'menu.saveScene', commands.saveScene),
        ],
      },
    ];
  },
};

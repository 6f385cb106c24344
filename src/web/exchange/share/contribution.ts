import {
  mdiContentSaveOutline,
  mdiFileCodeOutline,
  mdiFolderOpenOutline,
  mdiLinkVariant,
  mdiMapOutline,
  mdiShareVariant,
} from '@mdi/js';

import type { Contribution, FeatureEntry } from '../../kit/features/feature';
import { t } from '../../kit/i18n';
import type { TextKey } from '../../kit/i18n/texts';
import { useCommands } from './use-commands';

/** Sharing, saving and opening. */
export const contribution: Contribution = {
  menu() {
    const commands = useCommands();
    const entry = (id: string, icon: string, key: TextKey, act: FeatureEntry['act']): FeatureEntry => ({
      id,
      testId: `menu-${id}`,
      icon,
      title: t(key),
      act,
    });
    return [
      {
        group: 'files',
        order: 0,
        entries: () => [
          entry('share', mdiShareVariant, 'bar.share', (menu) => menu.openDialog(() => import('./ShareDialog.vue'))),
        ],
      },
      {
        group: 'files',
        order: 20,
        entries: () => [
          entry('save', mdiContentSaveOutline, 'bar.save', commands.save),
          entry('save-program', mdiFileCodeOutline, 'menu.saveProgram', commands.saveProgram),
          entry('save-scene', mdiMapOutline, 'menu.saveScene', commands.saveScene),
          entry('open', mdiFolderOpenOutline, 'menu.openFile', commands.load),
          entry('open-link', mdiLinkVariant, 'menu.openLink', (menu) =>
            menu.openDialog(() => import('./OpenLinkDialog.vue')),
          ),
        ],
      },
    ];
  },
};

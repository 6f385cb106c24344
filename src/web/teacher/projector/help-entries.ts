import { mdiProjectorScreenOutline } from '@mdi/js';

import type { HelpEntry } from '../../kit/features/feature';
import { t } from '../../kit/i18n';
import showWords from '../../session/layout/words';
import words from './words';

export const helpEntries: readonly HelpEntry[] = [
  {
    id: 'projector',
    section: 'menu',
    after: 'class',
    icon: mdiProjectorScreenOutline,
    name: () => t(showWords.projector.title),
    text: () => t(words.help),
    covers: ['menu-projector', 'projector-open'],
  },
];

import { mdiGhostOutline } from '@mdi/js';

import type { HelpEntry } from '../../kit/features/feature';
import { t } from '../../kit/i18n';
import showWords from '../../session/layout/words';
import helpWords from './words/help';

export const helpEntries: readonly HelpEntry[] = [
  {
    id: 'ghosts',
    section: 'arena',
    after: 'show',
    icon: mdiGhostOutline,
    name: () => t(showWords.ghost.title),
    text: () => t(helpWords.ghosts),
    covers: ['ghost-away', 'ghost-*'],
  },
];

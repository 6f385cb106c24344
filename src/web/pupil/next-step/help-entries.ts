import { mdiRestart } from '@mdi/js';

import type { HelpEntry } from '../../kit/features/feature';
import { t } from '../../kit/i18n';
import words from './words';

export const helpEntries: readonly HelpEntry[] = [
  {
    id: 'no-progress',
    section: 'arena',
    after: 'verdict',
    icon: mdiRestart,
    name: () => t(words.referee.noProgress),
    text: () => t(words.referee.help),
    covers: ['no-progress'],
  },
];

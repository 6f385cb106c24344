import { mdiFlaskOutline } from '@mdi/js';

import type { HelpEntry } from '../../kit/features/feature';
import { t } from '../../kit/i18n';
import words from './words';

export const helpEntries: readonly HelpEntry[] = [
  {
    id: 'lab',
    section: 'program',
    icon: mdiFlaskOutline,
    name: () => t(words.title),
    text: () => t(words.help),
    covers: ['menu-lab', 'try-number'],
  },
];

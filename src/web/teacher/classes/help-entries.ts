import { mdiAccountGroupOutline } from '@mdi/js';

import type { HelpEntry } from '../../kit/features/feature';
import { t } from '../../kit/i18n';
import words from './words';

export const helpEntries: readonly HelpEntry[] = [
  {
    id: 'classes',
    section: 'menu',
    after: 'class',
    icon: mdiAccountGroupOutline,
    name: () => t(words.title),
    text: () => t(words.help),
    covers: ['menu-classes'],
  },
];

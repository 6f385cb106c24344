import { mdiKeyboardOutline, mdiSteering } from '@mdi/js';

import type { HelpEntry } from '../../kit/features/feature';
import { t } from '../../kit/i18n';
import words from './words';

export const helpEntries: readonly HelpEntry[] = [
  {
    id: 'modes',
    section: 'arena',
    after: 'arena-hand',
    icon: mdiSteering,
    name: () => t(words.title),
    text: () => t(words.help),
    covers: ['mode-*'],
  },
  {
    id: 'key-modes',
    section: 'keys',
    icon: mdiKeyboardOutline,
    name: () => t(words.key),
    text: () => t(words.key),
    covers: [],
    keys: ['Alt', '1 2 3'],
  },
];

import { mdiTrophyOutline } from '@mdi/js';

import type { HelpEntry } from '../../kit/features/feature';
import { t } from '../../kit/i18n';
import words from './words';

export const helpEntries: readonly HelpEntry[] = [
  {
    id: 'tournament',
    section: 'menu',
    after: 'projector',
    icon: mdiTrophyOutline,
    name: () => t(words.title),
    text: () => `${t(words.help)} ${t(words.finalKeys)}`,
    covers: ['menu-tournament'],
  },
];

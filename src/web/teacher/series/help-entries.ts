import { mdiFormatListNumbered } from '@mdi/js';

import type { HelpEntry } from '../../kit/features/feature';
import { t } from '../../kit/i18n';
import wayWords from '../../session/task/series/words';
import words from './words';

export const helpEntries: readonly HelpEntry[] = [
  {
    id: 'make-series',
    section: 'menu',
    after: 'task-maker',
    icon: mdiFormatListNumbered,
    name: () => t(words.title),
    text: () => t(words.help),
    covers: ['menu-make-series'],
  },
  {
    id: 'series',
    section: 'menu',
    after: 'make-series',
    icon: mdiFormatListNumbered,
    name: () => t(wayWords.back),
    text: () => t(words.helpBack),
    covers: ['menu-series'],
  },
];

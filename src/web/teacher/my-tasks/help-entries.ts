import { mdiFolderStarOutline } from '@mdi/js';

import type { HelpEntry } from '../../kit/features/feature';
import { t } from '../../kit/i18n';
import shelfWords from '../shelf/words';
import words from './words';

export const helpEntries: readonly HelpEntry[] = [
  {
    id: 'my-tasks',
    section: 'menu',
    after: 'task-maker',
    icon: mdiFolderStarOutline,
    name: () => t(shelfWords.title),
    text: () => t(words.help),
    covers: ['desk-tasks'],
  },
];

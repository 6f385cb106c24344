import { mdiFolderStarOutline } from '@mdi/js';

import type { HelpEntry } from '../../kit/features/feature';
import { t } from '../../kit/i18n';
import words from './words';
import noticeWords from './words/notice';

export const helpEntries: readonly HelpEntry[] = [
  {
    id: 'works',
    section: 'menu',
    icon: mdiFolderStarOutline,
    name: () => t(noticeWords.title),
    text: () => t(words.help),
    covers: ['menu-works'],
  },
];

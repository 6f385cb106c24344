import { mdiRobotHappyOutline } from '@mdi/js';

import type { HelpEntry } from '../../kit/features/feature';
import { t } from '../../kit/i18n';
import words from './words';
import helpWords from './words/help';

export const helpEntries: readonly HelpEntry[] = [
  {
    id: 'gallery',
    section: 'menu',
    after: 'panes',
    icon: mdiRobotHappyOutline,
    name: () => t(words.gallery),
    text: () => t(helpWords.gallery),
    covers: ['gallery'],
  },
];

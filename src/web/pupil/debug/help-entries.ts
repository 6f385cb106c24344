import { mdiDebugStepOver, mdiVariable } from '@mdi/js';

import type { HelpEntry } from '../../kit/features/feature';
import { t } from '../../kit/i18n';
import words from './words';
import helpWords from './words/help';

export const helpEntries: readonly HelpEntry[] = [
  {
    id: 'line-by-line',
    section: 'program',
    icon: mdiDebugStepOver,
    name: () => t(words.bar),
    text: () => t(helpWords.lineByLine),
    covers: ['step-*', 'words.goOn', 'ran-open', 'ran-close'],
  },
  {
    id: 'variables',
    section: 'program',
    after: 'line-by-line',
    icon: mdiVariable,
    name: () => t(words.variables),
    text: () => t(helpWords.variables),
    covers: ['board-tabs', 'words.variables', 'tab-board', 'tab-variables', 'past-variables', 'variable', 'call'],
  },
];

import { mdiEyeOutline, mdiGhostOutline, mdiLightbulbOnOutline, mdiRadar } from '@mdi/js';

import type { HelpEntry } from '../../kit/features/feature';
import { t } from '../../kit/i18n';
import showWords from '../../session/layout/words';
import words from './words';
import viewWords from './words/view';
import helpWords from './words/help';

export const helpEntries: readonly HelpEntry[] = [
  {
    id: 'sight',
    section: 'arena',
    after: 'ask-why',
    icon: mdiRadar,
    name: () => t(viewWords.sight),
    text: () => t(helpWords.sight),
    covers: ['robot-sight', 'show-sight'],
  },
  {
    id: 'show',
    section: 'arena',
    after: 'sight',
    icon: mdiEyeOutline,
    name: () => t(viewWords.title),
    text: () => t(helpWords.view),
    covers: ['show', 'show-*', 'fit', 'near', 'zoom-selected', 'zoom-true', 'cinema', 'fullscreen', 'page-back'],
  },
  {
    id: 'switches',
    section: 'arena',
    after: 'show',
    icon: mdiLightbulbOnOutline,
    name: () => t(words.switches.title),
    text: () => t(helpWords.switches),
    covers: ['switch-*'],
  },
  {
    id: 'ghosts',
    section: 'arena',
    after: 'show',
    icon: mdiGhostOutline,
    name: () => t(showWords.ghost.title),
    text: () => t(helpWords.ghosts),
    covers: ['ghost-away', 'ghost-*'],
  },
];

import { mdiAccountVoice } from '@mdi/js';

import type { HelpEntry } from '../../kit/features/feature';
import { t } from '../../kit/i18n';
import showWords from '../../session/layout/words';
import words from './words';

export const helpEntries: readonly HelpEntry[] = [
  {
    id: 'tell',
    section: 'arena',
    after: 'ghosts',
    icon: mdiAccountVoice,
    name: () => t(showWords.tell.title),
    text: () => t(words.help),
    covers: ['tell-switch', 'tones-switch', 'show-tones'],
  },
];

import { mdiBookOpenVariantOutline, mdiShieldCheckOutline } from '@mdi/js';

import type { HelpEntry } from '../../kit/features/feature';
import { t } from '../../kit/i18n';
import words from './words';

export const helpEntries: readonly HelpEntry[] = [
  {
    ...{ id: 'handbook', section: 'menu', after: 'teachers', icon: mdiBookOpenVariantOutline },
    name: () => t(words.title),
    text: () => t(words.help),
    covers: ['desk-handbook'],
  },
  {
    ...{ id: 'data-protection', section: 'menu', after: 'handbook', icon: mdiShieldCheckOutline },
    name: () => t(words.sheet.title),
    text: () => t(words.sheet.help),
    covers: ['desk-data-protection'],
  },
];

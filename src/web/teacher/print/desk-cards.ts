import { mdiFileDocumentOutline } from '@mdi/js';

import type { DeskCards } from '../../kit/features/desk-card';
import { t } from '../../kit/i18n';
import words from './words';

export const deskCards: DeskCards = () => [
  {
    part: 'teach',
    order: 20,
    testId: 'menu-worksheet',
    icon: mdiFileDocumentOutline,
    title: () => t(words.sheet),
    about: () => t(words.card),
    open: (desk) => desk.openDialog(() => import('./SheetDialog.vue')),
  },
];

import { mdiAccountGroupOutline } from '@mdi/js';

import type { DeskCards } from '../../kit/features/desk-card';
import { t } from '../../kit/i18n';
import { CLASSES } from './address';
import words from './words';

export const deskCards: DeskCards = () => [
  {
    part: 'check',
    order: 20,
    testId: 'menu-classes',
    icon: mdiAccountGroupOutline,
    title: () => t(words.title),
    about: () => t(words.card),
    open: (desk) => desk.openPage(CLASSES),
  },
];

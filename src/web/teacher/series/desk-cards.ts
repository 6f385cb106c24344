import { mdiFormatListNumbered } from '@mdi/js';

import type { DeskCards } from '../../kit/features/desk-card';
import { t } from '../../kit/i18n';
import words from './words';

export const deskCards: DeskCards = () => [
  {
    part: 'prepare',
    order: 20,
    testId: 'menu-make-series',
    icon: mdiFormatListNumbered,
    title: () => t(words.title),
    about: () => t(words.card),
    open: (desk) => desk.openPage('make-series'),
  },
];

import { mdiFormatListNumbered } from '@mdi/js';

import type { DeskCards } from '../../kit/features/desk-card';
import { t } from '../../kit/i18n';
import { usePage } from '../../kit/parts';
import { seriesDraft } from './series-draft';
import words from './words';

export const deskCards: DeskCards = () => {
  const { series } = seriesDraft(usePage());
  return [
    {
      part: 'prepare',
      order: 20,
      testId: 'menu-make-series',
      icon: mdiFormatListNumbered,
      title: () => t(words.title),
      about: () => t(words.card),
      left() {
        const { title, tasks } = series.value;
        if (tasks.length === 0) return null;
        return { title: title || t(words.series), about: t(words.left, { count: tasks.length }) };
      },
      open: (desk) => desk.openPage('make-series'),
    },
  ];
};

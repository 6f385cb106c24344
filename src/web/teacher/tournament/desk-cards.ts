import { mdiTrophyOutline } from '@mdi/js';

import type { DeskCards } from '../../kit/features/desk-card';
import { t } from '../../kit/i18n';
import { usePage } from '../../kit/parts';
import { playedHere } from './use-tournament';
import words from './words';

export const deskCards: DeskCards = () => {
  const played = playedHere(usePage());
  return [
    {
      part: 'teach',
      order: 20,
      testId: 'menu-tournament',
      icon: mdiTrophyOutline,
      title: () => t(words.title),
      about: () => t(words.card),
      left() {
        const { name, count } = played.value;
        return count === 0 ? null : { title: name, about: t(words.left, { count }) };
      },
      open: (desk) => desk.openPage('tournament'),
    },
  ];
};

import { mdiFolderStarOutline } from '@mdi/js';

import type { DeskCards } from '../../kit/features/desk-card';
import { t } from '../../kit/i18n';
import { usePage } from '../../kit/parts';
import { useRun } from '../../session/run/parts';
import { useLayout } from '../../session/layout/parts';
import { useWork } from '../../session/work/model/parts';
import { shelfOf } from '../shelf/use-shelf';
import shelfWords from '../shelf/words';
import { detailsOf, fitting, noWish } from './shelf-rows';
import { openWork, rowOf } from './use-own-tasks';
import words from './words';

/** The way to the own tasks, and each of them by its name, text or details. */
export const deskCards: DeskCards = (search) => {
  const app = { ...usePage(), ...useRun(), ...useWork(), ...useLayout() };
  const { items } = shelfOf(app);
  return [
    {
      part: 'prepare',
      order: 25,
      testId: 'desk-tasks',
      icon: mdiFolderStarOutline,
      title: () => t(shelfWords.title),
      about: () => t(words.card),
      count: () => items.value.length,
      found: () =>
        fitting(items.value.map(rowOf), { ...noWish, search: search.value }).map((row) => ({
          ...{ id: row.id, title: row.name, about: detailsOf(row) },
          open: () => openWork(app, row.item.work),
        })),
      open: (desk) => desk.openPage('tasks'),
    },
  ];
};

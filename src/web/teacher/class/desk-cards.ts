import { mdiClipboardCheckOutline } from '@mdi/js';
import { shallowRef } from 'vue';

import type { DeskCards } from '../../kit/features/desk-card';
import { t } from '../../kit/i18n';
import { readClass, type KeptClass } from './kept-class';
import words from './words';

export const deskCards: DeskCards = () => {
  const kept = shallowRef<KeptClass | null>(null);
  void readClass().then(
    (found) => (kept.value = found),
    () => undefined, // without a database there is none
  );
  return [
    {
      part: 'check',
      order: 10,
      testId: 'menu-class',
      icon: mdiClipboardCheckOutline,
      title: () => t(words.title),
      about: () => t(words.card),
      left: () =>
        kept.value?.task
          ? { title: kept.value.task.name, about: t(words.left, { count: kept.value.rows.length }) }
          : null,
      open: (desk) => desk.openPage('class'),
    },
  ];
};

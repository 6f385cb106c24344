import { mdiFolderStarOutline } from '@mdi/js';

import type { DeskCards } from '../../kit/features/desk-card';
import { t } from '../../kit/i18n';
import { useWorks } from './use-works';
import { isFound } from './works-list';
import words from './words';
import noticeWords from './words/notice';

/** The way to the own works, and each of them by its name or its program. */
export const deskCards: DeskCards = (search) => {
  const { all } = useWorks();
  return [
    {
      part: 'prepare',
      order: 30,
      testId: 'desk-works',
      icon: mdiFolderStarOutline,
      title: () => t(noticeWords.title),
      about: () => t(words.card),
      found: () =>
        all.value
          .filter((work) => isFound(work, search.value))
          .map(({ id, name }) => ({
            ...{ id, title: name, about: t(noticeWords.title) },
            open: (desk) => desk.openPage('works', id),
          })),
      open: (desk) => desk.openPage('works'),
    },
  ];
};

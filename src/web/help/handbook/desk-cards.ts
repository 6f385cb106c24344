import { mdiBookOpenVariantOutline, mdiShieldCheckOutline } from '@mdi/js';
import { computed } from 'vue';

import type { DeskCards } from '../../kit/features/desk-card';
import { t } from '../../kit/i18n';
import { findPlaces } from './find-places';
import { addressOf, loadHandbook } from './load-book';
import { useBook } from './use-book';
import { SHEET } from './sheet-address';
import words from './words';

/** The ways to the handbook and to the sheet on data protection; the search finds the sections of the handbook. */
export const deskCards: DeskCards = (search) => {
  const { book } = useBook(loadHandbook, () => search.value !== '');
  const found = computed(() => findPlaces(book.value ?? [], search.value));
  return [
    {
      ...{ part: 'prepare', order: 40, testId: 'desk-handbook', icon: mdiBookOpenVariantOutline },
      title: () => t(words.title),
      about: () => t(words.card),
      found: () =>
        found.value.map((place) => ({
          ...{ id: addressOf(place), title: place.section.title, about: place.chapter.title },
          open: (desk) => desk.openPage('handbook', addressOf(place)),
        })),
      open: (desk) => desk.openPage('handbook'),
    },
    {
      ...{ part: 'check', order: 40, testId: 'desk-data-protection', icon: mdiShieldCheckOutline },
      title: () => t(words.sheet.title),
      about: () => t(words.sheet.card),
      open: (desk) => desk.openPage('handbook', SHEET),
    },
  ];
};

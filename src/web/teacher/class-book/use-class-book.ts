import { dayOf, type Day } from '#core/day';

import { askBeforeLeaving } from '../../kit/state/ask-before-leaving';
import { lateModel } from '../../kit/state/late-models';
import { ClassBook } from './class-book';
import { KeptClasses } from './kept-classes';

/** The teacher's classes: they stay while the page is open, also out of sight. Leaving asks if a change would be lost. */
export const classBookOf = lateModel(() => {
  const book = new ClassBook(new KeptClasses());
  askBeforeLeaving(() => book.isUnsaved.value);
  return book;
});

/** The day by this device's calendar. */
export function today(): Day {
  const now = new Date();
  return dayOf(now.getFullYear(), now.getMonth() + 1, now.getDate());
}

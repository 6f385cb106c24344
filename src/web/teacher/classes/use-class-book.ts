import { effectScope, watch } from 'vue';

import { lateModel } from '../../kit/state/late-models';
import { ClassBook } from './class-book';
import { KeptClasses } from './kept-classes';

/** The teacher's classes: they stay while the page is open, also out of sight. Leaving asks if a change would be lost. */
export const classBookOf = lateModel(() => {
  const book = new ClassBook(new KeptClasses());
  const ask = (event: Event): void => event.preventDefault();
  effectScope(true).run(() =>
    watch(book.isUnsaved, (asks) =>
      asks ? addEventListener('beforeunload', ask) : removeEventListener('beforeunload', ask),
    ),
  );
  return book;
});

/** The day by this device's calendar. */
export function today(): string {
  const now = new Date();
  const two = (number: number): string => String(number).padStart(2, '0');
  return `${String(now.getFullYear())}-${two(now.getMonth() + 1)}-${two(now.getDate())}`;
}

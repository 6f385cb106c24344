import { shallowRef, watch, type ShallowRef } from 'vue';

import { shownLanguage, type Language } from '../../kit/i18n';
import type { Book } from './book';

/** A book in the page's language, which it follows. */
export interface ShownBook {
  /** `null` while it loads. */
  readonly book: Readonly<ShallowRef<Book | null>>;
  /** True if it could not be loaded. */
  readonly isMissing: Readonly<ShallowRef<boolean>>;
}

/**
 * Loads a book, and once more when another language is chosen. Called in a set-up.
 *
 * @param isWanted waits until this is true
 */
export function useBook(load: (language: Language) => Promise<Book>, isWanted: () => boolean = () => true): ShownBook {
  const book = shallowRef<Book | null>(null);
  const isMissing = shallowRef(false);
  watch(
    [shownLanguage, isWanted],
    async ([language, wanted]) => {
      if (!wanted) return;
      try {
        const loaded = await load(language);
        if (shownLanguage() === language) book.value = loaded; // otherwise another one is loading
        isMissing.value = false;
      } catch {
        isMissing.value = true;
      }
    },
    { immediate: true },
  );
  return { book, isMissing };
}

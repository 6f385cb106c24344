import { shallowRef, type ShallowRef } from 'vue';

import type { TextKey, TextValues } from '../i18n/texts';

/** A short message at the foot of the page. It names a text, so that it follows the language. */
export interface Notice {
  readonly kind: 'ok' | 'info' | 'warn' | 'error';
  readonly key: TextKey;
  readonly values?: TextValues;
  /** One thing to do about it. */
  readonly action?: { readonly key: TextKey; readonly values?: TextValues; readonly run: () => void };
}

/** The message that is shown now, if any; a new one takes the place of the old. */
export interface NoticesModel {
  readonly current: Readonly<ShallowRef<Notice | null>>;
  show(notice: Notice): void;
  close(): void;
}

export function useNotices(): NoticesModel {
  const current = shallowRef<Notice | null>(null);
  return {
    current,
    show: (notice) => {
      current.value = notice;
    },
    close: () => {
      current.value = null;
    },
  };
}

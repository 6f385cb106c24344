import { shallowRef, watch, type ShallowRef } from 'vue';

import type { TextKey, TextValues } from './i18n/texts';

/** A short message at the foot of the page. It names a text, so that it follows the language. */
export interface Notice {
  readonly kind: 'ok' | 'info' | 'warn' | 'error';
  readonly key: TextKey;
  readonly values?: TextValues;
  /** One thing to do about it. */
  readonly action?: { readonly key: TextKey; readonly values?: TextValues; readonly run: () => void };
  /** True if the message still holds and its action can be done; the message is closed as soon as it is not. */
  readonly holds?: () => boolean;
  /** It is shown as long as it holds, however long that is. */
  readonly stays?: true;
}

/** The message that is shown now, if any; a new one takes the place of the old. */
export interface NoticesModel {
  readonly current: Readonly<ShallowRef<Notice | null>>;
  show(notice: Notice): void;
  close(): void;
}

export function createNotices(): NoticesModel {
  const current = shallowRef<Notice | null>(null);
  const close = (): void => {
    current.value = null;
  };
  // At once: a late press must not trigger something else.
  watch(
    () => current.value?.holds?.() ?? true,
    (holds) => {
      if (!holds) close();
    },
    { flush: 'sync' },
  );
  return {
    current,
    show: (notice) => {
      current.value = notice;
    },
    close,
  };
}

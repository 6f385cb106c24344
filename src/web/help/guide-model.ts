import { shallowRef, type ShallowRef } from 'vue';

import type { EntryId } from './guide/content/entry-ids';

/** Whether the help is requested, and where; whether it is visible. */
export interface GuideModel {
  /** `null`: closed; an entry's name, or `''` for the help's beginning. */
  readonly at: Readonly<ShallowRef<EntryId | '' | null>>;
  /** Whether it is on the page yet: it is fetched with the first request. */
  readonly isShown: ShallowRef<boolean>;
  /** Opens the help at one of its entries, or at its beginning. */
  readonly open: (entry?: EntryId | '') => void;
  readonly close: () => void;
}

/** Makes the model of a closed help. */
export function createGuide(): GuideModel {
  const at = shallowRef<EntryId | '' | null>(null);
  return {
    at,
    isShown: shallowRef(false),
    open: (entry = '') => void (at.value = entry),
    close: () => void (at.value = null),
  };
}

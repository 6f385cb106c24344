import { shallowRef, type ShallowRef } from 'vue';

import type { HelpEntry } from '../kit/features/feature';

/** The state of the help: whether it is requested, at which entry, and whether it is on the page. */
export interface GuideModel {
  /** `null`: closed; an entry's name, or `''` for the help's beginning. */
  readonly at: Readonly<ShallowRef<string | null>>;
  /** True if it is on the page yet: it is fetched with the first request. */
  readonly isShown: ShallowRef<boolean>;
  /** Opens the help at one of its entries, or at its beginning. */
  readonly open: (entry?: string) => void;
  readonly close: () => void;
  /** Loads the entries that features bring. */
  readonly contributed: () => Promise<readonly HelpEntry[]>;
}

/** Makes the model of a closed help. */
export function createGuide(contributed: GuideModel['contributed']): GuideModel {
  const at = shallowRef<string | null>(null);
  return {
    at,
    isShown: shallowRef(false),
    open: (entry = '') => void (at.value = entry),
    close: () => void (at.value = null),
    contributed,
  };
}

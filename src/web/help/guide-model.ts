import { shallowRef, type ShallowRef } from 'vue';

/** The state of the help: whether it is requested, and at which entry. */
export interface GuideModel {
  /** `null`: closed; an entry's name, or `''` for the help's beginning. */
  readonly at: Readonly<ShallowRef<string | null>>;
  /** Opens the help at one of its entries, or at its beginning. */
  readonly open: (entry?: string) => void;
  readonly close: () => void;
}

/** Makes the model of a closed help. */
export function createGuide(): GuideModel {
  const at = shallowRef<string | null>(null);
  return { at, open: (entry = '') => void (at.value = entry), close: () => void (at.value = null) };
}

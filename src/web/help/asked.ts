import { shallowRef, type ShallowRef } from 'vue';

/** The greeting as somebody asks for it who has been here before. */
export interface Asked {
  /** True until there is an answer, a run, or anything else to look at. */
  readonly isAsked: Readonly<ShallowRef<boolean>>;
  readonly ask: () => void;
  readonly end: () => void;
}

export function createAsked(): Asked {
  const isAsked = shallowRef(false);
  return { isAsked, ask: () => void (isAsked.value = true), end: () => void (isAsked.value = false) };
}

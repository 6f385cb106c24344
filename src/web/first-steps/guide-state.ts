import { readonly, shallowRef, type ShallowRef } from 'vue';

import type { EntryId } from './guide/content/entry-ids';

/** What the help is to show: `null`: it is closed; an entry's name, or `''` for its beginning. */
const at = shallowRef<EntryId | '' | null>(null);

/** Whether it is on the page by now: asked for, it may take a moment. */
const isShown = shallowRef(false);

/** Whether the help is asked for, and where; whether it is seen. The page has one, so this is said once. */
export const guide: {
  readonly at: Readonly<ShallowRef<EntryId | '' | null>>;
  readonly isShown: Readonly<ShallowRef<boolean>>;
} = { at: readonly(at), isShown: readonly(isShown) };

/** Opens the help, from anywhere: at one of its entries, or at its beginning. It comes late and may take a moment. */
export function openGuide(entry: EntryId | '' = ''): void {
  at.value = entry;
}

/** Closes the help. */
export function closeGuide(): void {
  at.value = null;
}

/** Said by the help itself, as it comes and goes. */
export function guideIsShown(shown: boolean): void {
  isShown.value = shown;
}

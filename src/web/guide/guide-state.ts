import { readonly, shallowRef, type ShallowRef } from 'vue';

import type { EntryId } from './entry-ids';

/** What the help is to show: `null`: it is closed; an entry's name, or `''` for its beginning. */
const at = shallowRef<EntryId | '' | null>(null);

/** Whether the help is open, and where. The page has one, so this is said once. */
export const guide: { readonly at: Readonly<ShallowRef<EntryId | '' | null>> } = { at: readonly(at) };

/** Opens the help, from anywhere: at one of its entries, or at its beginning. It comes late and may take a moment. */
export function openGuide(entry: EntryId | '' = ''): void {
  at.value = entry;
}

/** Closes the help. */
export function closeGuide(): void {
  at.value = null;
}

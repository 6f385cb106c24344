import { readonly, shallowRef, type ShallowRef } from 'vue';

const isOpen = shallowRef(false);

/** Whether the tour is on. The page has one, so this is said once; where it was left is a setting. */
export const tour: { readonly isOpen: Readonly<ShallowRef<boolean>> } = { isOpen: readonly(isOpen) };

/** Begins the tour, or goes on where it was left. It comes late and may take a moment. */
export function openTour(): void {
  isOpen.value = true;
}

/** Ends it on the page; what is kept about it is the business of whoever ends it. */
export function closeTour(): void {
  isOpen.value = false;
}

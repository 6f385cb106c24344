import { shallowRef, type ShallowRef } from 'vue';

/** True if the tour is on. Where it was left is a setting. */
export interface TourModel {
  readonly isOpen: Readonly<ShallowRef<boolean>>;
  /** Begins the tour, or goes on where it was left. It is fetched first and may take a moment. */
  readonly open: () => void;
  /** Takes it off the page; what is kept about it is up to the caller. */
  readonly close: () => void;
}

/** Makes the model of a tour that has not begun. */
export function createTour(): TourModel {
  const isOpen = shallowRef(false);
  return { isOpen, open: () => void (isOpen.value = true), close: () => void (isOpen.value = false) };
}

import { shallowRef, type ShallowRef } from 'vue';

/** The state of the tour. The step at which it was left is a setting. */
export interface TourModel {
  readonly isOpen: Readonly<ShallowRef<boolean>>;
  /** Begins the tour, or resumes it where it was left. It is loaded first, which may take a moment. */
  readonly open: () => void;
  /** Removes it from the page; whether it can be resumed is up to the caller. */
  readonly close: () => void;
}

/** Makes the model of a tour that has not begun. */
export function createTour(): TourModel {
  const isOpen = shallowRef(false);
  return { isOpen, open: () => void (isOpen.value = true), close: () => void (isOpen.value = false) };
}

import { shallowRef, type ShallowRef } from 'vue';

/** A value that is loaded after the page, and stays the same from then on. */
export interface Arrival<T> {
  /** `null`: not loaded yet. Read in templates, it is followed. */
  readonly value: T | null;
  set(value: T): void;
}

/** Makes the place for a value that is loaded later. */
export function arrival<T>(): Arrival<T> {
  const value: ShallowRef<T | null> = shallowRef(null);
  return {
    get value() {
      return value.value;
    },
    set: (it) => void (value.value = it),
  };
}

import { shallowRef, type ShallowRef } from 'vue';

/** Something that comes late with the page, and is then the same for good. */
export interface Arrival<T> {
  /** `null`: it has not come yet. Read in templates, it is followed when it does. */
  readonly value: T | null;
  come(value: T): void;
}

/** A place for something that comes late. */
export function arrival<T>(): Arrival<T> {
  const value: ShallowRef<T | null> = shallowRef(null);
  return {
    get value() {
      return value.value;
    },
    come: (it) => void (value.value = it),
  };
}

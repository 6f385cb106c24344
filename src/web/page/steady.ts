import { computed, type ComputedRef } from 'vue';

/** A computed list or record that stays the same object while its values do, so that nothing is redrawn from it. */
export function steady<T extends object>(values: () => T): ComputedRef<T> {
  return computed<T>((before) => {
    const now = values();
    return before !== undefined && sameValues(before, now) ? before : now;
  });
}

/** Lists within are compared by their values as well, such as the colours of lights. */
function isSame(one: unknown, other: unknown): boolean {
  return Object.is(one, other) || (Array.isArray(one) && Array.isArray(other) && sameValues(one, other));
}

function sameValues(one: object, other: object): boolean {
  const keys = Object.keys(one);
  return (
    keys.length === Object.keys(other).length &&
    keys.every((key) => isSame(one[key as keyof typeof one], other[key as keyof typeof other]))
  );
}

import { computed, type ComputedRef } from 'vue';

import { isSame } from '#core/same';

/** A computed list or record that stays the same object while its values do, so that nothing is redrawn from it. */
export function steady<T extends object>(values: () => T): ComputedRef<T> {
  return computed<T>((before) => {
    const now = values();
    return before !== undefined && isSame(before, now) ? before : now;
  });
}

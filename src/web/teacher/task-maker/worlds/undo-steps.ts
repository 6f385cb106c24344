import { computed, shallowRef, type ComputedRef } from 'vue';

/** Most steps that can be undone. Chosen: as far back as anybody goes. */
const MOST = 100;

/** Steps back and forth through what was there before each change. */
export interface UndoSteps<T> {
  readonly canUndo: ComputedRef<boolean>;
  readonly canRedo: ComputedRef<boolean>;
  /** Keeps what is there, which is about to be changed. */
  keep(present: T): void;
  /** @returns what was there before the last change; `undefined`: nothing */
  undo(present: T): T | undefined;
  /** @returns what the last undo took away; `undefined`: nothing */
  redo(present: T): T | undefined;
}

/** Creates steps without any. */
export function undoSteps<T>(): UndoSteps<T> {
  const past = shallowRef<readonly T[]>([]);
  const future = shallowRef<readonly T[]>([]);
  return {
    canUndo: computed(() => past.value.length > 0),
    canRedo: computed(() => future.value.length > 0),
    keep(present) {
      past.value = [...past.value.slice(1 - MOST), present];
      future.value = [];
    },
    undo(present) {
      const last = past.value.at(-1);
      if (last === undefined) return undefined;
      past.value = past.value.slice(0, -1);
      future.value = [...future.value, present];
      return last;
    },
    redo(present) {
      const next = future.value.at(-1);
      if (next === undefined) return undefined;
      future.value = future.value.slice(0, -1);
      past.value = [...past.value, present];
      return next;
    },
  };
}

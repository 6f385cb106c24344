import { onScopeDispose, shallowRef, watch, type ShallowRef, type WatchSource } from 'vue';

/** Interval at which constantly changing numbers are rewritten, in ms. */
const EVERY_MS = 100; // chosen: ten times a second is as fast as anyone reads

/** A value that follows its source ten times a second at most, the last one included. */
export function slowly<T>(source: WatchSource<T>): Readonly<ShallowRef<T>> {
  const shown = shallowRef() as ShallowRef<T>;
  let timer: ReturnType<typeof setTimeout> | undefined;
  let next: { readonly value: T } | null = null;
  function show(): void {
    timer = undefined;
    if (next === null) return;
    shown.value = next.value;
    next = null;
    timer = setTimeout(show, EVERY_MS);
  }
  watch(
    source,
    (value) => {
      next = { value };
      if (timer === undefined) show();
    },
    { immediate: true, flush: 'sync' },
  );
  onScopeDispose(() => clearTimeout(timer));
  return shown;
}

import { onScopeDispose, shallowRef, type ShallowRef } from 'vue';

/** The value of the first query that matches the window, now and from now on; `other` if none does. */
export function useFirstMatch<K>(queries: readonly [K, string][], other: K): Readonly<ShallowRef<K>> {
  const lists = queries.map(([kind, query]) => [kind, matchMedia(query)] as const);
  const measure = (): K => lists.find(([, list]) => list.matches)?.[0] ?? other;
  const kind = shallowRef(measure());
  const follow = (): void => {
    kind.value = measure();
  };
  for (const [, list] of lists) list.addEventListener('change', follow);
  onScopeDispose(() => {
    for (const [, list] of lists) list.removeEventListener('change', follow);
  });
  return kind;
}

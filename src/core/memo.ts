/*
 * The only places where a module remembers something: what it makes is the same each time and never changes, so nobody can
 * tell whether it was made just now. What changes belongs to the models of a room.
 */

/** Makes a thing at the first call and returns the same one at each later call. */
export function once<T>(make: () => T): () => T {
  let made: T | undefined;
  return () => (made ??= make());
}

/** The same for things that are fetched: after a failure the next call fetches again. */
export function fetchedOnce<T>(fetch: () => Promise<T>): () => Promise<T> {
  let coming: Promise<T> | null = null;
  return () =>
    (coming ??= fetch().catch((error: unknown) => {
      coming = null;
      throw error;
    }));
}

/** Makes one thing for each name or number. */
export const memo = <K extends string | number, T>(make: (of: K) => T): ((of: K) => T) =>
  remembering(new Map<K, T>(), make);

/** Makes one thing for each object, which is remembered as long as that lives. */
export const memoOf = <K extends object, T>(make: (of: K) => T): ((of: K) => T) =>
  remembering(new WeakMap<K, T>(), make);

function remembering<K, T>(
  made: { get(of: K): T | undefined; has(of: K): boolean; set(of: K, one: T): unknown },
  make: (of: K) => T,
): (of: K) => T {
  return (of) => {
    const known = made.get(of);
    if (known !== undefined || made.has(of)) return known as T;
    const one = make(of);
    made.set(of, one);
    return one;
  };
}

/** Makes a thing for an object by something else, such as the zoom; of each object the last one is remembered. */
export function lastMadeOf<K extends object, By, T>(
  make: (of: K, by: By) => T,
  isSame: (one: By, other: By) => boolean = Object.is,
): (of: K, by: By) => T {
  const last = new WeakMap<K, { readonly by: By; readonly one: T }>();
  return (of, by) => {
    const known = last.get(of);
    if (known !== undefined && isSame(known.by, by)) return known.one;
    const one = make(of, by);
    last.set(of, { by, one });
    return one;
  };
}

/** Notes on values that never change, by identity: an equal value that is another object has none. */
export function notesOn<K extends object, T>(): Pick<WeakMap<K, T>, 'get' | 'has' | 'set'> {
  return new WeakMap<K, T>();
}

/**
 * Creates a cache: a thing is made once for each key; when the cache is full, it is emptied.
 *
 * @param most maximum number of things
 * @returns a function that gives the thing of a key, and makes it with `make` if there is none
 */
export function createCache<Thing>(most: number): (key: readonly unknown[], make: () => Thing) => Thing {
  const made = new Map<string, Thing>();
  return (key, make) => {
    const name = key.join();
    const known = made.get(name);
    if (known !== undefined) return known;
    if (made.size >= most) made.clear();
    const thing = make();
    made.set(name, thing);
    return thing;
  };
}

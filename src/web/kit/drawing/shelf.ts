/**
 * Keeps what was made, so that it is made once for each key; when there is too much, all of it goes.
 *
 * @param most so many are kept
 * @returns what there is for a key, else what `make` gives
 */
export function createShelf<Thing>(most: number): (key: readonly unknown[], make: () => Thing) => Thing {
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

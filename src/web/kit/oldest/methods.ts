/**
 * Methods that the page uses and the oldest browsers lack: Chrome has all of it from 110 on, Safari from 16.
 * `filled.d.ts` declares the same names, so that nothing newer is used. As everywhere in the language, `this` is the list.
 */

type Row<T> = T[];
type Test<T> = (value: T, index: number, row: Row<T>) => unknown;

/** Index of the place `index`, which counts from the end if negative. @throws RangeError if there is none */
function placeIn(row: Row<unknown>, index: number): number {
  const place = Math.trunc(index) || 0;
  const found = place < 0 ? place + row.length : place;
  if (found < 0 || found >= row.length) throw new RangeError('Invalid index');
  return found;
}

function findLastIndex<T>(this: Row<T>, test: Test<T>, owner?: unknown): number {
  for (let place = this.length - 1; place >= 0; place--) {
    if (test.call(owner, this[place] as T, place, this)) return place;
  }
  return -1;
}

/** Methods of lists and of typed arrays. */
export const ofEveryList = {
  findLastIndex,
  findLast<T>(this: Row<T>, test: Test<T>, owner?: unknown): T | undefined {
    return this[findLastIndex.call(this, test as Test<unknown>, owner)];
  },
  toReversed<T>(this: Row<T>): Row<T> {
    return this.slice().reverse();
  },
  toSorted<T>(this: Row<T>, compare?: (a: T, b: T) => number): Row<T> {
    return this.slice().sort(compare);
  },
  with<T>(this: Row<T>, index: number, value: T): Row<T> {
    const changed = this.slice();
    changed[placeIn(this, index)] = value;
    return changed;
  },
};

/** Methods of lists alone: those that change their length. */
export const ofLists = {
  toSpliced<T>(this: Row<T>, ...how: [number, number, ...T[]]): Row<T> {
    const changed = this.slice();
    changed.splice(...how);
    return changed;
  },
};

/** Methods of `Object`. */
export const ofObjects = {
  hasOwn: (owner: object, name: PropertyKey): boolean => Object.prototype.hasOwnProperty.call(owner, name),
};

/** Methods of abort signals. */
export const ofSignals = {
  throwIfAborted(this: AbortSignal): void {
    if (this.aborted) throw new DOMException('Aborted', 'AbortError');
  },
};

/** Methods of a canvas. The page draws only one radius for all corners, limited to what fits. */
export const ofCanvas = {
  roundRect(this: CanvasRenderingContext2D, x: number, y: number, width: number, height: number, radius = 0): void {
    const [right, bottom] = [x + width, y + height];
    const corner = Math.min(radius, Math.abs(width) / 2, Math.abs(height) / 2);
    const across = Math.sign(width) * corner;
    this.moveTo(x + across, y);
    this.arcTo(right, y, right, bottom, corner);
    this.arcTo(right, bottom, x, bottom, corner);
    this.arcTo(x, bottom, x, y, corner);
    this.arcTo(x, y, right, y, corner);
    this.closePath();
    this.moveTo(x, y);
  },
};

/** Adds those of `methods` that `owner` lacks; like its own ones they are not enumerable. */
export function fill(owner: object | undefined, methods: Readonly<Record<string, unknown>>): void {
  if (owner === undefined) return;
  for (const [name, value] of Object.entries(methods)) {
    if (!(name in owner)) Object.defineProperty(owner, name, { value, writable: true, configurable: true });
  }
}

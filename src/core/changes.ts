/**
 * The changes of plain data (objects, arrays, numbers, texts …): a list of one holds a new value, anything else the
 * changes below, by key or place.
 */
export type Changes = readonly [unknown] | { readonly [key: string]: Changes };

/** The changes that turn `before` into `after`; `undefined` if the two are equal. Shares nothing with either. */
export function changesOf(before: unknown, after: unknown): Changes | undefined {
  if (Object.is(before, after)) return undefined;
  if (!isAlike(before, after)) return [copyOf(after)];
  const found: Record<string, Changes> = {};
  let isAny = false;
  for (const [key, value] of Object.entries(after as object)) {
    const change = changesOf(before[key], value);
    if (change === undefined) continue;
    found[key] = change;
    isAny = true;
  }
  return isAny ? found : undefined;
}

/** Data after its changes. Unchanged parts are the same objects as before. */
export function withChanges(before: unknown, changes: Changes | undefined): unknown {
  if (changes === undefined) return before;
  if (isValue(changes)) return changes[0];
  const after = (Array.isArray(before) ? [...(before as unknown[])] : { ...(before as object) }) as Keyed;
  for (const [key, change] of Object.entries(changes)) after[key] = withChanges(after[key], change);
  return after;
}

type Keyed = Record<string, unknown>;

const isValue = (changes: Changes): changes is readonly [unknown] => Array.isArray(changes);

/** True if both are lists of one length, or objects with the same keys: then their parts can be compared. */
function isAlike(before: unknown, after: unknown): before is Keyed {
  if (Array.isArray(before)) return Array.isArray(after) && before.length === after.length;
  if (!isPlain(before) || !isPlain(after)) return false;
  const keys = Object.keys(after);
  return keys.length === Object.keys(before).length && keys.every((key) => Object.hasOwn(before, key));
}

const isPlain = (value: unknown): value is Keyed => Object.prototype.toString.call(value) === '[object Object]';

function copyOf(value: unknown): unknown {
  if (Array.isArray(value)) return value.map(copyOf);
  if (isPlain(value)) return Object.fromEntries(Object.entries(value).map(([key, each]) => [key, copyOf(each)]));
  return ArrayBuffer.isView(value) ? (value as Uint8Array).slice() : value;
}

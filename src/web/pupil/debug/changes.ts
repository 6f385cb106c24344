import type { Variable, Variables } from '#vm/debug/variables';

/**
 * The former values of changed variables, by the keys that `globalName` and `localName` give; `null`: there was none.
 */
export type Before = ReadonlyMap<string, string | null>;

export const globalName = (name: string): string => `global ${name}`;

/** Key of a variable of a function call; `depth`: the number of calls around it. */
export const localName = (depth: number, name: string): string => `local ${depth} ${name}`;

/**
 * The variables that have another value than at the stop before. Those of a call that has just begun are not among
 * them.
 */
export function changesBetween(before: Variables | null, now: Variables): Before {
  const changes = new Map<string, string | null>();
  if (before === null) return changes;
  compare(before.globals, now.globals, globalName, changes);
  now.stack.forEach((entry, place) => {
    const depth = now.stack.length - 1 - place;
    const same = before.stack[before.stack.length - 1 - depth];
    if (same?.function !== entry.function || same.file !== entry.file) return;
    compare(same.locals, entry.locals, (name) => localName(depth, name), changes);
  });
  return changes;
}

function compare(
  before: readonly Variable[],
  now: readonly Variable[],
  key: (name: string) => string,
  changes: Map<string, string | null>,
): void {
  const known = new Map(before.map(({ name, value }) => [name, value.text]));
  for (const { name, value } of now) {
    const last = known.get(name);
    if (last !== value.text) changes.set(key(name), last ?? null);
  }
}

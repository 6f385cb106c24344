import type { Value } from './syscall';

/** A whole number from Python's int or bool; `null` for anything else (also for a missing argument). */
export function wholeOf(value: Value | undefined): number | null {
  if (value === true) return 1;
  if (value === false) return 0;
  return typeof value === 'number' && Number.isInteger(value) ? value : null;
}

/** A number from Python's int, float or bool; `null` for anything else. */
export function numberOf(value: Value | undefined): number | null {
  if (typeof value === 'number' && Number.isFinite(value)) return value;
  return wholeOf(value);
}

/** Text from Python's str; empty for anything else. */
export function textOf(value: Value | undefined): string {
  return typeof value === 'string' ? value : '';
}

/** Error numbers as MicroPython's `errno` has them; syscalls return them negative. */
export const Errno = { ENOENT: 2, EBADF: 9, ENODEV: 19, ENOSPC: 28 } as const;

/** The value of a table under a name given by Python; names that only JavaScript's objects have are ignored. */
export function ownOf<T>(table: Readonly<Record<string, T>>, name: Value | undefined): T | undefined {
  const text = textOf(name);
  return Object.hasOwn(table, text) ? table[text] : undefined;
}

/** The entry of a list at the whole number that Python gives; none for anything else. */
export function entryOf<T>(list: readonly T[], place: Value | undefined): T | undefined {
  return list[wholeOf(place) ?? -1];
}

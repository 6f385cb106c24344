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

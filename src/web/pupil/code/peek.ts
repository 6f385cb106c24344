/** A line of the program, with its number from 1 on. */
export interface PeekLine {
  readonly number: number;
  readonly text: string;
}

/**
 * Some lines of a program round one of them; without one, the first. Empty lines at the end are left out.
 *
 * @param around its number; 0: none
 */
export function peekAt(program: string, around: number, count: number): readonly PeekLine[] {
  const all = program.trimEnd().split(/\r?\n/);
  const first = Math.max(0, Math.min(all.length - count, around - 1 - Math.floor(count / 2)));
  return all.slice(first, first + count).map((text, at) => ({ number: first + at + 1, text }));
}

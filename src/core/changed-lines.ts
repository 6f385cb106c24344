/** Two texts line by line, and how many lines they share at their beginning and, apart from those, at their end. */
export interface ChangedLines {
  readonly old: readonly string[];
  readonly now: readonly string[];
  readonly head: number;
  readonly tail: number;
}

/** Parts two texts into what has stayed before and after the lines that were changed. */
export function changedLines(before: string, after: string): ChangedLines {
  const [old, now] = [before.split(/\r?\n/), after.split(/\r?\n/)];
  const shorter = Math.min(old.length, now.length);
  let head = 0;
  while (head < shorter && old[head] === now[head]) head += 1;
  let tail = 0;
  while (tail < shorter - head && old.at(-1 - tail) === now.at(-1 - tail)) tail += 1;
  return { old, now, head, tail };
}

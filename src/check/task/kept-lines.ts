import { changedLines } from '#core/changed-lines';

/**
 * Finds locked lines in a changed text. Neighbouring lines must remain neighbours, without new lines between them.
 *
 * @param lines their numbers before, from 1
 * @returns their numbers now; `null`: one of them is not there any more
 */
export function keptLines(before: string, after: string, lines: readonly number[]): readonly number[] | null {
  const { old, now, head, tail } = changedLines(before, after);
  const grown = now.length - old.length;
  const kept: number[] = [];
  let free = 0;
  for (const { first, count } of blocksOf(lines, old.length)) {
    const at = placeOf(first, count);
    if (at === null) return null;
    for (let line = 0; line < count; line += 1) kept.push(at + line + 1);
    free = at + count;
  }
  return kept;

  /** Before and after what was changed it is clear; in between it is looked for, in the order of the blocks. */
  function placeOf(first: number, count: number): number | null {
    if (first + count <= head) return first;
    if (first >= old.length - tail) return first + grown;
    for (let at = Math.max(free, Math.min(first, head)); at + count <= now.length; at += 1)
      if (isAt(first, count, at)) return at;
    return null;
  }
  function isAt(first: number, count: number, at: number): boolean {
    for (let line = 0; line < count; line += 1) if (old[first + line] !== now[at + line]) return false;
    return true;
  }
}

/** Neighbouring lines together, from 0; lines that the text has not are nothing. */
function blocksOf(lines: readonly number[], of: number): readonly { readonly first: number; readonly count: number }[] {
  const blocks: { first: number; count: number }[] = [];
  for (const line of [...new Set(lines)].sort((one, other) => one - other)) {
    if (line < 1 || line > of) continue;
    const last = blocks.at(-1);
    if (last !== undefined && last.first + last.count === line - 1) last.count += 1;
    else blocks.push({ first: line - 1, count: 1 });
  }
  return blocks;
}

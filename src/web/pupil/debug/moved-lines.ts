import { changedLines } from '#core/changed-lines';

/** Larger changed parts than this (lines before × lines now) are not compared. Chosen: some ms. */
const MOST = 1_000_000;

/** The new places of a text's lines in a changed one. */
export interface MovedLines {
  /** The line now that was `line` before, both from 1; `null`: it is not there any more. */
  now(line: number): number | null;
  /** The line before that is `line` now; `null`: it was not there. */
  before(line: number): number | null;
}

/** Compares two texts line by line: what both have in the same order has stayed. */
export function movedLines(before: string, after: string): MovedLines {
  const { old, now, head, tail } = changedLines(before, after);
  const pairs = pairsOf(old.slice(head, old.length - tail), now.slice(head, now.length - tail));
  const forwards = new Map(pairs.map(([from, to]) => [from + head, to + head]));
  const backwards = new Map(pairs.map(([from, to]) => [to + head, from + head]));
  const find = (line: number, [of, to]: readonly [number, number], known: ReadonlyMap<number, number>) => {
    const place = line - 1;
    if (place < 0 || place >= of) return null;
    if (place < head) return line;
    if (place >= of - tail) return line + to - of;
    const found = known.get(place);
    return found === undefined ? null : found + 1;
  };
  return {
    now: (line) => find(line, [old.length, now.length], forwards),
    before: (line) => find(line, [now.length, old.length], backwards),
  };
}

/** The longest row of lines that both have: their places before and now. */
function pairsOf(old: readonly string[], now: readonly string[]): readonly (readonly [number, number])[] {
  if (old.length * now.length === 0 || old.length * now.length > MOST) return [];
  // lengths[i][j]: how many lines old from i and now from j have in common
  const lengths = Array.from({ length: old.length + 1 }, () => new Uint32Array(now.length + 1));
  const common = (i: number, j: number): number => lengths[i]?.[j] ?? 0;
  for (let i = old.length - 1; i >= 0; i -= 1)
    for (let j = now.length - 1; j >= 0; j -= 1) {
      const row = lengths[i] ?? new Uint32Array();
      row[j] = old[i] === now[j] ? common(i + 1, j + 1) + 1 : Math.max(common(i + 1, j), common(i, j + 1));
    }
  const pairs: (readonly [number, number])[] = [];
  for (let i = 0, j = 0; i < old.length && j < now.length;)
    if (old[i] === now[j]) pairs.push([i++, j++]);
    else if (common(i + 1, j) >= common(i, j + 1)) i += 1;
    else j += 1;
  return pairs;
}

/**
 * The most likely intended one of these names: the nearest by letters left out, added, exchanged or swapped. `null` if
 * none is near enough, or two are equally near.
 */
export function nearName(written: string, names: Iterable<string>): string | null {
  const most = mostSlips(written.length);
  let best: { readonly name: string; readonly slips: number } | null = null;
  let isSure = false;
  for (const name of new Set(names)) {
    if (name === written || Math.abs(name.length - written.length) > most) continue;
    const slips = slipsBetween(written, name);
    if (isOtherWord(written, name) && slips >= 1) continue;
    if (slips > most || (best !== null && slips > best.slips)) continue;
    isSure = best === null || slips < best.slips;
    best = { name, slips };
  }
  return isSure && best !== null ? best.name : null;
}

/** Three letters with one exchanged are mostly another word: `led` is not `len`. */
const isOtherWord = (one: string, other: string): boolean =>
  one.length < 4 &&
  one.length === other.length &&
  Array.from(one).sort().join('') !== Array.from(other).sort().join('');

/** Maximum number of slips in a word; wrong capitals are half a slip each. Chosen: short names differ in little. */
const mostSlips = (length: number): number => (length < 3 ? 0.5 : length < 6 ? 1 : 2);

/** Optimal string alignment: each step is one letter, or two neighbours that changed places. */
function slipsBetween(one: string, other: string): number {
  let beforeLast: number[] = [];
  let last = Array.from({ length: other.length + 1 }, (_, column) => column);
  for (let row = 1; row <= one.length; row++) {
    const now = [row];
    for (let column = 1; column <= other.length; column++) {
      const [mine, theirs] = [one.charAt(row - 1), other.charAt(column - 1)];
      const exchanged = mine === theirs ? 0 : mine.toLowerCase() === theirs.toLowerCase() ? 0.5 : 1;
      const swapped =
        mine === other.charAt(column - 2) && one.charAt(row - 2) === theirs ? at(beforeLast, column - 2) + 1 : Infinity;
      now.push(Math.min(at(last, column) + 1, at(now, column - 1) + 1, at(last, column - 1) + exchanged, swapped));
    }
    [beforeLast, last] = [last, now];
  }
  return at(last, other.length);
}

const at = (row: readonly number[], column: number): number => row[column] ?? Infinity;

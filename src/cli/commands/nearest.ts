/**
 * The known word that was probably meant: the only one that begins so or with which it begins, else the nearest by typing
 * mistakes; `null`: none is near.
 */
export function nearest(word: string, known: readonly string[]): string | null {
  const same = known.filter((one) => one.length >= LEAST && word.length >= LEAST && (one.startsWith(word) || word.startsWith(one))); // prettier-ignore
  if (same.length === 1) return same[0] ?? null;
  const most = Math.max(1, Math.floor(word.length / 3));
  const by = known.map((one) => ({ one, mistakes: mistakesBetween(word, one) }));
  const best = by.reduce<(typeof by)[number] | null>(
    (least, each) => (least === null || each.mistakes < least.mistakes ? each : least),
    null,
  );
  return best !== null && best.mistakes <= most && best.mistakes < best.one.length ? best.one : null;
}

/** Chosen: two letters say too little about which word was begun. */
const LEAST = 3;

/** Letters that are added, left out, exchanged for another one or with their neighbour. */
function mistakesBetween(one: string, other: string): number {
  // Distances of the beginnings of `one` to all beginnings of `other`, row by row.
  const rows: number[][] = [Array.from({ length: other.length + 1 }, (_, place) => place)];
  const at = (row: number, place: number): number => rows[row]?.[place] ?? Infinity;
  for (let row = 1; row <= one.length; row++) {
    rows[row] = [row];
    for (let place = 1; place <= other.length; place++) {
      const isSame = one[row - 1] === other[place - 1];
      const isSwapped = row > 1 && place > 1 && one[row - 1] === other[place - 2] && one[row - 2] === other[place - 1];
      rows[row]?.push(
        Math.min(
          at(row - 1, place) + 1,
          at(row, place - 1) + 1,
          at(row - 1, place - 1) + (isSame ? 0 : 1),
          isSwapped ? at(row - 2, place - 2) + 1 : Infinity,
        ),
      );
    }
  }
  return at(one.length, other.length);
}

/** The sentence on a value that an option does not have: the one that was probably meant, and all that there are. */
export function notKnown(option: string, typed: string, known: readonly string[]): string {
  const meant = nearest(typed, known);
  return `--${option}: "${typed}" is not known.${meant === null ? '' : ` Did you mean ${meant}?`} Known: ${known.join(', ')}.`;
}

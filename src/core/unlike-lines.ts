/** Most pairs of lines that are compared, so that a text of ten thousand lines costs no memory. Chosen: 1,400 against 1,400. */
const MOST_PAIRS = 2_000_000;

/** Places of the lines of two texts that the other one does not have there: all others are the longest common run of lines. */
export interface UnlikeLines {
  readonly one: ReadonlySet<number>;
  readonly other: ReadonlySet<number>;
}

/** Compares two texts line by line; blanks at the end of a line and empty lines do not count. */
export function unlikeLines(one: readonly string[], other: readonly string[]): UnlikeLines {
  const [own, theirs] = [counted(one), counted(other)];
  const none: UnlikeLines = { one: new Set(), other: new Set() };
  if (own.length * theirs.length > MOST_PAIRS) return none;
  const lengths = commonLengths(own, theirs);
  const unlike = { one: new Set<number>(), other: new Set<number>() };
  let [at, beside] = [0, 0];
  while (at < own.length || beside < theirs.length) {
    const [line, opposite] = [own[at], theirs[beside]];
    if (line !== undefined && opposite !== undefined && line.text === opposite.text) {
      at += 1;
      beside += 1;
    } else if (
      opposite === undefined ||
      (line !== undefined && (lengths[at + 1]?.[beside] ?? 0) >= (lengths[at]?.[beside + 1] ?? 0))
    ) {
      if (line !== undefined) unlike.one.add(line.place);
      at += 1;
    } else {
      unlike.other.add(opposite.place);
      beside += 1;
    }
  }
  return unlike;
}

interface Line {
  readonly text: string;
  readonly place: number;
}

const counted = (lines: readonly string[]): readonly Line[] =>
  lines.flatMap((line, place) => (line.trim() === '' ? [] : [{ text: line.trimEnd(), place }]));

/** Length of the longest common run of lines from each pair of places on. */
function commonLengths(one: readonly Line[], other: readonly Line[]): readonly Uint16Array[] {
  const lengths = Array.from({ length: one.length + 1 }, () => new Uint16Array(other.length + 1));
  for (let at = one.length - 1; at >= 0; at -= 1)
    for (let beside = other.length - 1; beside >= 0; beside -= 1) {
      const [row, below] = [lengths[at], lengths[at + 1]];
      if (row === undefined || below === undefined) continue;
      const isSame = one[at]?.text === other[beside]?.text;
      row[beside] = isSame ? (below[beside + 1] ?? 0) + 1 : Math.max(below[beside] ?? 0, row[beside + 1] ?? 0);
    }
  return lengths;
}

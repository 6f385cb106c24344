/** A curve that can be chosen. */
export interface Series {
  /** Unique, and the same in every run. */
  readonly id: string;
  readonly name: string;
  /** Curves of one unit share an axis. Empty for a plain number, `0/1` for on or off. */
  readonly unit: string;
  /** True if it jumps from value to value, as something does that is on or off. */
  readonly isStepped: boolean;
}

/** The values of a curve, in the order of time; `null` where there is none, such as a distance without an echo. */
export interface Points {
  readonly timesS: readonly number[];
  readonly values: readonly (number | null)[];
}

export const noPoints: Points = { timesS: [], values: [] };

/** A source of curves: the run's measurements, or a program's output. A further kind of curve is a further source. */
export interface SeriesSource {
  /** Heading of its curves in the list. */
  readonly title: () => string;
  /** The curves there are now. */
  list(): readonly Series[];
  /**
   * Takes in what has come since; only the chosen curves need points.
   *
   * @returns whether there is more to take in
   */
  update(chosen: ReadonlySet<string>): boolean;
  /** The points of one of the chosen curves. */
  pointsOf(id: string): Points;
}

/** The value of a curve at a time: the last one at or before it. */
export function valueAt({ timesS, values }: Points, timeS: number): number | null {
  let from = 0;
  let until = timesS.length;
  while (from < until) {
    const middle = (from + until) >> 1;
    if ((timesS[middle] ?? 0) <= timeS) from = middle + 1;
    else until = middle;
  }
  return values[from - 1] ?? null;
}

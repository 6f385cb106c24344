/** A stretch of time, or of what else runs across, that is shown. */
export type Span = readonly [from: number, to: number];

/** Shortest stretch that is shown. Chosen: five moments of the tape, in seconds. */
const LEAST = 0.1;

/**
 * The stretch that is longer or shorter by a factor, around a place that stays where it is; `null`: the whole.
 *
 * @param times factor; below 1 less is shown
 */
export function zoomed([from, to]: Span, [first, last]: Span, at: number, times: number): Span | null {
  const width = Math.max(LEAST, (to - from) * times);
  if (width >= last - first) return null;
  const share = to > from ? (at - from) / (to - from) : 0.5;
  return within([at - share * width, at + (1 - share) * width], [first, last]);
}

/** The stretch moved so that it does not leave the whole. */
export function within([from, to]: Span, [first, last]: Span): Span {
  const by = from < first ? first - from : to > last ? last - to : 0;
  return [Math.max(first, from + by), Math.min(last, to + by)];
}

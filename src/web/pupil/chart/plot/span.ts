/** A stretch of time, or of what else runs across, that is shown. */
export type Span = readonly [from: number, to: number];

/** The least that is shown. Chosen: five moments of the tape, in seconds. */
const LEAST = 0.1;

/** Shows more or less, around a place that stays where it is. `null`: the whole. @param times below 1 shows less */
export function zoomed([from, to]: Span, [first, last]: Span, at: number, times: number): Span | null {
  const width = Math.max(LEAST, (to - from) * times);
  if (width >= last - first) return null;
  const share = to > from ? (at - from) / (to - from) : 0.5;
  return within([at - share * width, at + (1 - share) * width], [first, last]);
}

/** Moves a stretch so that it does not leave the whole. */
export function within([from, to]: Span, [first, last]: Span): Span {
  const by = from < first ? first - from : to > last ? last - to : 0;
  return [Math.max(first, from + by), Math.min(last, to + by)];
}

/** A column of times: how many seconds one of its units has; `null`: its heading does not say. */
export interface TimeColumn {
  readonly unitS: number | null;
}

/**
 * Headings used for time by programs and people. The board itself: `Time (seconds)`; MakeCode’s other boards: `Time
 * (sec.)`.
 */
const HEADING = /^(?:time|zeit|temps|tempo|t)(?:\s*[([]\s*([a-z]+)\.?\s*[)\]]|[\s_]+([a-z]+)\.?)?$/i;
const UNITS: readonly (readonly [RegExp, number])[] = [
  [/^(?:ms|milli\w+)$/, 0.001],
  [/^(?:s|secs?|seconds?|sekunden?|secondes?|second[oi])$/, 1],
  [/^(?:min|mins|minutes?|minuten?|minut[oi])$/, 60],
  [/^(?:h|hrs?|hours?|stunden?|std|heures?|or[ae])$/, 3600],
  [/^(?:d|days?|tage?|jours?|giorn[oi])$/, 86_400],
];

/** The unit of a column of times, read from its heading; `null`: not a column of times. */
export function timeOf(heading: string): TimeColumn | null {
  const found = HEADING.exec(heading.trim());
  if (found === null) return null;
  const unit = (found[1] ?? found[2])?.toLowerCase();
  if (unit === undefined) return { unitS: null };
  const known = UNITS.find(([name]) => name.test(unit));
  return known === undefined ? null : { unitS: known[1] };
}

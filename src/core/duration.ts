const US_PER = { ms: 1000, s: 1_000_000, min: 60_000_000, h: 3_600_000_000 } as const;

/** Longest time that may be requested: a day. Chosen: more than enough for a run, and all figures remain exact. */
const MAX_US = 24 * US_PER.h;

/**
 * Reads a time with its unit, such as `500ms`, `20s`, `1.5s`, `2min` or `3h`.
 *
 * @returns whole µs, or a problem that names the value and the remedy
 */
export function parseDuration(text: string): { readonly us: number } | { readonly problem: string } {
  const match = /^(\d+(?:\.\d+)?)(ms|s|min|h)?$/.exec(text.trim());
  if (!match) return { problem: `"${text.slice(0, 40)}" is not a time. Write it like 500ms, 20s or 2min.` };
  const [, number = '', unit] = match;
  if (unit !== 'ms' && unit !== 's' && unit !== 'min' && unit !== 'h') {
    return { problem: `"${number}" has no unit. Did you mean ${number}s? Times are written like 500ms, 20s or 2min.` };
  }
  const us = Math.round(Number(number) * US_PER[unit]);
  if (!(us <= MAX_US)) return { problem: `"${text.slice(0, 40)}" is too long; the limit is 24h.` };
  return { us };
}

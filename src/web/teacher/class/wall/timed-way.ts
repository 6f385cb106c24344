import type { WorldResult } from '#check/result';
import type { Point } from '#scene/scene';

/** A way with its times. */
type Way = Pick<WorldResult, 'trail' | 'trailMs'>;

/** Simulated ms at which the last of them was at its end, and had passed if it has. */
export const lastMs = (ways: readonly { readonly way: Way; readonly passedMs: number | null }[]): number =>
  ways.reduce((last, { way, passedMs }) => Math.max(last, way.trailMs.at(-1)?.at(-1) ?? 0, passedMs ?? 0), 0);

/** The part of a path driven until then: whole pieces, and the last one up to a place between two of its points. */
export function drivenUntil({ trail, trailMs }: Way, ms: number): readonly (readonly Point[])[] {
  return trail.flatMap((piece, index) => {
    const times = trailMs[index] ?? [];
    const later = times.findIndex((time) => time > ms);
    if (later === 0) return [];
    if (later < 0) return [piece];
    return [[...piece.slice(0, later), between(piece, times, { later, ms })]];
  });
}

/** The place between two points. */
function between(
  piece: readonly Point[],
  times: readonly number[],
  { later, ms }: { readonly later: number; readonly ms: number },
): Point {
  const [[x, y], [toX, toY]] = [piece[later - 1] ?? [0, 0], piece[later] ?? [0, 0]];
  const [from, to] = [times[later - 1] ?? 0, times[later] ?? 0];
  const part = (ms - from) / (to - from);
  return [x + (toX - x) * part, y + (toY - y) * part];
}

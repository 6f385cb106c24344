import type { Speed } from '#simulation/pace';

/** The point at which a run's simulated time was last tied to the wall clock. */
export interface Anchor {
  readonly wallMs: number;
  readonly simulatedUs: number;
  readonly speed: Speed;
}

/** Further behind than this (ms of wall time) a run does not try to catch up: a burst after a hiccup would look like a jump. */
const BACKLOG_MS = 100; // chosen: six frames, still caught up without being seen

/** Simulated time, in whole µs, that a run anchored at `anchor` should have reached at `wallMs`; `Infinity` at full speed. */
export function dueUs(anchor: Anchor, wallMs: number): number {
  if (anchor.speed === 'max') return Infinity;
  return anchor.simulatedUs + Math.floor(Math.max(0, wallMs - anchor.wallMs) * 1000 * anchor.speed);
}

/**
 * The anchor to continue with: the same one, or a new one at the present when the machine has fallen behind for good.
 */
export function withoutBacklog(anchor: Anchor, wallMs: number, simulatedUs: number): Anchor {
  if (anchor.speed === 'max') return anchor;
  const behindMs = (dueUs(anchor, wallMs) - simulatedUs) / 1000 / anchor.speed;
  return behindMs > BACKLOG_MS ? { ...anchor, wallMs, simulatedUs } : anchor;
}

/** The next piece of simulated time (µs), chosen so that one piece takes about 1 ms of wall time. */
export function nextPieceUs(pieceUs: number, tookMs: number): number {
  if (tookMs > 2) return Math.max(4000, Math.floor(pieceUs / 2)); // 4 ms: one step of the world, the least that shows
  if (tookMs < 0.5) return Math.min(64_000, pieceUs * 2); // 64 ms: four frames, the most that still looks smooth
  return pieceUs;
}

/** Measures the factor that a run actually reaches: simulated seconds per wall second over the last second or so. */
export interface SpeedMeter {
  /** Records the progress of the run. */
  note(wallMs: number, simulatedUs: number): void;
  /** The factor, or `null` until a quarter of a second has been seen. */
  factor(): number | null;
  /** Forgets everything, as after a pause. */
  reset(): void;
}

/** Creates a meter that remembers the last `windowMs` of wall time. */
export function createSpeedMeter(windowMs = 1000): SpeedMeter {
  let seen: { wallMs: number; simulatedUs: number }[] = [];
  return {
    note(wallMs, simulatedUs) {
      const last = seen.at(-1);
      if (last !== undefined && wallMs - last.wallMs < 50) return;
      seen.push({ wallMs, simulatedUs });
      while (seen.length > 2 && wallMs - (seen[1]?.wallMs ?? wallMs) >= windowMs) seen.shift();
    },
    factor() {
      const first = seen[0];
      const last = seen.at(-1);
      if (first === undefined || last === undefined || last.wallMs - first.wallMs < 250) return null;
      return (last.simulatedUs - first.simulatedUs) / 1000 / (last.wallMs - first.wallMs);
    },
    reset() {
      seen = [];
    },
  };
}

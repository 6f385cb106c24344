import type { Vec } from '#core/geometry';
import { distanceMm } from '#editor/plane';

/** Two taps in this time, in ms, are a double tap. Chosen: what browsers take for a double click. */
const SECOND_MS = 500;

/** Remembers the last tap: another one there, soon after, is the second of a double tap. */
export class TapMemory {
  private last: { readonly at: Vec; readonly atMs: number } | null = null;

  /** Whether a press is the second one. World mm, wall time in ms. */
  isSecond(at: Vec, nowMs: number, reachMm: number): boolean {
    if (this.last === null || nowMs - this.last.atMs > SECOND_MS) return false;
    return distanceMm(this.last.at, at) <= reachMm;
  }

  /** A gesture is over; `null`: it was no single tap. */
  note(at: Vec | null, nowMs: number): void {
    this.last = at && { at, atMs: nowMs };
  }
}

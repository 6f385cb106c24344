import type { Vec } from '#core/geometry';
import { isTap, startOf } from '#editor/drag';
import { distanceMm } from '#editor/plane';
import type { Drag, Opened } from '#editor/tools/tool';
import type { Gesture } from './gesture';

/** Two taps within this time, in ms, are a double tap. Chosen: as browsers do for a double click. */
const SECOND_MS = 500;

/** Remembers the last tap: another one there, soon after, is the second of a double tap. */
export class TapMemory {
  private last: { readonly at: Vec; readonly atMs: number } | null = null;

  /** True if a press is the second one. World mm, wall time in ms. */
  isSecond(at: Vec, nowMs: number, reachMm: number): boolean {
    if (this.last === null || nowMs - this.last.atMs > SECOND_MS) return false;
    return distanceMm(this.last.at, at) <= reachMm;
  }

  /** Ends a gesture. Returns the thing that it opens if it was the second tap, or `null`. */
  opened({ tool, context, isSecond }: Gesture, drag: Drag, nowMs: number): Opened | null {
    const isOneTap = isTap(drag) && !drag.adds;
    const opened = isSecond && isOneTap ? (tool.opens?.(drag, context) ?? null) : null;
    this.last = isOneTap && opened === null ? { at: startOf(drag), atMs: nowMs } : null;
    return opened;
  }
}

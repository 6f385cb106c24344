import type { ArenaTool } from '../state/course-editor-model';

/** The fields of a pointer event that matter for a tap. */
export type Press = Pick<PointerEvent, 'pointerId' | 'clientX' | 'clientY' | 'timeStamp' | 'button'>;

/** How far a finger may slip in a tap, in px. Further, it scrolls. */
const SLIP_PX = 10;
/** A finger that rests longer asks for the hint, in ms: a little less than it takes to show. */
const REST_MS = 450;
/** The click of a tap comes within this time, in ms. */
const CLICK_MS = 500;

/**
 * Tells taps on tools apart from scrolling and from resting. A tap counts when the finger leaves: Chromium makes no click
 * of one that comes less than 300 ms after a stroke in the arena, since it might be the second of a double tap.
 */
export class ToolPress {
  private from: { readonly tool: ArenaTool; readonly press: Press } | null = null;
  private chosenAtMs = -Infinity;

  /** A finger or the main button goes down on a tool. */
  down(tool: ArenaTool, press: Press): void {
    this.chosenAtMs = -Infinity;
    this.from = press.button === 0 ? { tool, press } : null;
  }

  /** The browser scrolls with it. */
  cancel(): void {
    this.from = null;
  }

  /** The pointer goes up. Returns whether the tool is chosen. */
  up(tool: ArenaTool, press: Press): boolean {
    const { from } = this;
    this.from = null;
    if (from === null || from.tool !== tool || from.press.pointerId !== press.pointerId) return false;
    const slip = Math.max(Math.abs(press.clientX - from.press.clientX), Math.abs(press.clientY - from.press.clientY));
    if (slip > SLIP_PX || press.timeStamp - from.press.timeStamp > REST_MS) return false;
    this.chosenAtMs = press.timeStamp;
    return true;
  }

  /** A click: whether the tool is chosen. It is not where the tap before it was heard; keys have no `detail`. */
  click({ detail, timeStamp }: Pick<UIEvent, 'detail' | 'timeStamp'>): boolean {
    return detail === 0 || timeStamp - this.chosenAtMs > CLICK_MS;
  }
}

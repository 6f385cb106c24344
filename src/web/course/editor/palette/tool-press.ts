import type { ArenaTool } from '../state/course-editor-model';

/** The fields of a pointer event that matter for a tap. */
export type Press = Pick<PointerEvent, 'pointerId' | 'clientX' | 'clientY' | 'timeStamp' | 'button'>;

/** How far a finger may move during a tap, in px. Beyond that it scrolls. */
const SLIP_PX = 10;
/** A finger that rests for longer, in ms, asks for the hint: a little less than the hint takes to appear. */
const REST_MS = 450;
/** A tap's click follows within this time, in ms. */
const CLICK_MS = 500;

/**
 * Tells taps on tools from scrolling and long presses. A tap counts as soon as the finger is lifted: less than 300 ms
 * after a stroke in the arena Chromium fires no click, since the tap might be the second of a double tap.
 */
export class ToolPress {
  private from: { readonly tool: ArenaTool; readonly press: Press } | null = null;
  private chosenAtMs = -Infinity;

  /** A finger or the main button goes down on a tool. */
  down(tool: ArenaTool, press: Press): void {
    this.chosenAtMs = -Infinity;
    this.from = press.button === 0 ? { tool, press } : null;
  }

  /** The browser has taken the gesture over for scrolling. */
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

  /**
   * A click. Returns whether it chooses the tool: not if the tap before it already did. From the keyboard, `detail` is
   * 0.
   */
  click({ detail, timeStamp }: Pick<UIEvent, 'detail' | 'timeStamp'>): boolean {
    return detail === 0 || timeStamp - this.chosenAtMs > CLICK_MS;
  }
}

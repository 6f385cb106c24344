import { zoomed, within, type Span } from './span';

/** The acts of pointers on a chart. */
export interface PlotActs {
  /** The stretch that is shown, and the whole. */
  span(): Span;
  whole(): Span;
  /** The value on the horizontal axis at a place of the window; `null`: there is none. */
  acrossAt(clientX: number): number | null;
  /** Shows another stretch; `null`: the whole. */
  zoom(span: Span | null): void;
  /** Chooses a place. */
  seek(across: number): void;
  /** Notes the place that is pointed at; `null`: none any more. */
  hover(across: number | null): void;
  /** Shows the stretch that is being selected, in px of the area; `null`: none any more. */
  select(px: Span | null): void;
}

/** Farther than that a press is a drag, in px. */
const DRAG_PX = 6;

/**
 * A mouse chooses a time by a click and a stretch by a drag; a finger takes the time along, two fingers spread and move
 * the stretch; the wheel shows more or less.
 */
export class PlotPointers {
  private readonly down = new Map<number, { readonly startX: number; clientX: number }>();
  private pinch: { readonly widthPx: number; readonly middle: number; readonly span: Span } | null = null;
  private isDragged = false;

  constructor(private readonly acts: PlotActs) {}

  readonly press = (event: PointerEvent): void => {
    if (event.button !== 0) return;
    (event.currentTarget as HTMLElement).setPointerCapture(event.pointerId);
    this.down.set(event.pointerId, { startX: event.clientX, clientX: event.clientX });
    this.isDragged = false;
    if (this.down.size === 2) this.beginPinch();
    else if (event.pointerType !== 'mouse') this.seek(event.clientX);
  };

  readonly move = (event: PointerEvent): void => {
    const pointer = this.down.get(event.pointerId);
    if (pointer === undefined) {
      if (event.pointerType === 'mouse') this.acts.hover(this.acts.acrossAt(event.clientX));
      return;
    }
    pointer.clientX = event.clientX;
    if (this.pinch !== null) this.movePinch(this.pinch);
    else if (event.pointerType !== 'mouse') this.seek(event.clientX);
    else if (this.isDragged || Math.abs(event.clientX - pointer.startX) > DRAG_PX) {
      this.isDragged = true;
      const { left } = (event.currentTarget as HTMLElement).getBoundingClientRect();
      const ends = [pointer.startX - left, event.clientX - left].sort((one, other) => one - other);
      this.acts.select([ends[0] ?? 0, ends[1] ?? 0]);
    }
  };

  readonly release = (event: PointerEvent): void => {
    const pointer = this.down.get(event.pointerId);
    this.down.delete(event.pointerId);
    this.acts.select(null);
    if (pointer === undefined) return;
    const isPinched = this.pinch !== null;
    if (this.down.size < 2) this.pinch = null;
    if (isPinched || event.type === 'pointercancel') return;
    if (!this.isDragged) return this.seek(event.clientX);
    const ends = [this.acts.acrossAt(pointer.startX), this.acts.acrossAt(event.clientX)].filter((end) => end !== null);
    const [from, to] = ends.sort((one, other) => one - other);
    if (from !== undefined && to !== undefined && to > from) this.acts.zoom([from, to]);
  };

  readonly leave = (): void => this.acts.hover(null);

  readonly wheel = (event: WheelEvent): void => {
    const at = this.acts.acrossAt(event.clientX);
    if (at === null || event.deltaY === 0) return;
    event.preventDefault();
    this.acts.zoom(zoomed(this.acts.span(), this.acts.whole(), at, event.deltaY > 0 ? 1.25 : 0.8));
  };

  private seek(clientX: number): void {
    const at = this.acts.acrossAt(clientX);
    if (at !== null) this.acts.seek(at);
  }

  private beginPinch(): void {
    const [first, second] = [...this.down.values()].map(({ clientX }) => clientX);
    if (first === undefined || second === undefined) return;
    const middle = this.acts.acrossAt((first + second) / 2);
    if (middle !== null)
      this.pinch = { widthPx: Math.max(20, Math.abs(first - second)), middle, span: this.acts.span() };
  }

  private movePinch({ widthPx, middle, span }: NonNullable<PlotPointers['pinch']>): void {
    const [first, second] = [...this.down.values()].map(({ clientX }) => clientX);
    if (first === undefined || second === undefined) return;
    const whole = this.acts.whole();
    const next = zoomed(span, whole, middle, widthPx / Math.max(20, Math.abs(first - second)));
    this.acts.zoom(next);
    if (next === null) return;
    // What was between the fingers stays between them.
    const now = this.acts.acrossAt((first + second) / 2);
    if (now !== null) this.acts.zoom(within([next[0] + middle - now, next[1] + middle - now], whole));
  }
}

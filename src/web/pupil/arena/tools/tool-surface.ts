import type { Vec } from '#core/geometry';
import { plus } from '#editor/plane';
import { intoArena } from '#editor/snap';
import { withStuck } from '#editor/stuck';
import type { Drag, Mark } from '#editor/tools/tool';
import { applyEdit, type SceneEdit } from '#scene/edit';
import { backToCorners, goTo, setCorner, takeCornerBack } from './corner-gesture';
import { NOTHING, type SurfacePicture, type SurfacePorts } from './surface-ports';
import {
  dragOf,
  figuresNow,
  modifiersOf,
  initialGesture,
  pictureOf,
  toldBy,
  typeKey,
  type Gesture,
  type HeldKeys,
  type PointerKind,
  type SurfacePress,
  type ShownFigures,
} from './gesture';
import { eraserInk } from './eraser-veil';
import { TapMemory } from './tap-memory';
import { movePicture } from '../view/pinch';
import { toMm } from '../view/view-transform';

/** Distance that counts as on a thing, in px: half of a target. */
const REACH_PX: Readonly<Record<PointerKind, number>> = { mouse: 8, pen: 12, touch: 22 };

/** The crosshair moves in whole mm: anything nearer than this is hit. */
const KEY_REACH_MM = 9;

/** A hand that rests on the screen may be lifted a moment after the pen. */
const PALM_MS = 400;

/**
 * Turns pointers and keys over the arena into drags of the chosen tool, and their end into one edit. Takes events as
 * plain data, so that it can be tested without a browser.
 *
 * One finger, the pen or the first button uses the tool; two fingers always move and zoom the picture and drop a
 * gesture that one of them had begun. While a pen is down, touches are a resting hand.
 */
export class ToolSurface {
  private readonly pointers = new Map<number, { at: Vec; readonly kind: PointerKind }>();
  private gesture: Gesture | null = null;
  private panner: number | null = null;
  /** Two fingers were down: none of them draws until all are up. */
  private pinched = false;
  private penUntilMs = -Infinity;
  private hover: Vec | null = null;
  private keyAt: Vec | null = null;
  private kept: readonly Mark[] = [];
  private readonly taps = new TapMemory();

  /** @param kind the pointer that is expected to be used */
  constructor(
    private readonly ports: SurfacePorts,
    private kind: PointerKind = 'mouse',
  ) {}

  /** Distance that counts as on a thing for the latest pointer, in mm. */
  get reachMm(): number {
    return REACH_PX[this.kind] / this.ports.view().pxPerMm;
  }

  /** True during a gesture. */
  get isBusy(): boolean {
    return this.gesture !== null;
  }

  /** True while something is being drawn corner by corner. */
  get isChaining(): boolean {
    return (this.gesture?.corners ?? 0) > 0;
  }

  /** The edit that would result if the gesture ended now; `null`: none. */
  editSoFar(): SceneEdit | null {
    const gesture = this.gesture;
    return gesture && gesture.tool.edit(dragOf(gesture), gesture.context);
  }

  /** True while the pointer moves the picture. */
  get isPanning(): boolean {
    return this.panner !== null || this.pinched;
  }

  /** The figures of the gesture, or `null`. */
  get told(): ShownFigures | null {
    return this.gesture && toldBy(this.gesture);
  }

  /** Place of the keyboard's crosshair, world mm, or `null` while it is hidden. */
  get crosshair(): Vec | null {
    return this.keyAt;
  }

  /**
   * Handles a finger, pen or button that is pressed.
   *
   * @param nowMs wall time
   */
  pointerDown(press: SurfacePress, nowMs: number): void {
    const { id, at, kind } = press;
    if (kind === 'touch' && (this.hasPen() || nowMs < this.penUntilMs)) return;
    if (kind === 'pen') this.forgetTouches();
    this.kind = kind;
    this.pointers.set(id, { at, kind });
    this.hideCrosshair();
    this.kept = [];
    if (this.pointers.size > 1 || this.pinched) {
      this.letGo();
      this.pinched = kind === 'touch';
    } else if (press.pans) this.panner = id;
    else this.begin(id, toMm(this.ports.view(), at), press, nowMs);
    this.ports.changed();
  }

  /** Handles a pointer that moves, pressed or not, over these places (CSS px, oldest first). */
  pointerMove(id: number, places: readonly Vec[], keys: HeldKeys): void {
    const last = places[places.length - 1];
    const pointer = this.pointers.get(id);
    if (last === undefined) return;
    if (pointer === undefined) {
      if (this.pointers.size > 0) return; // a palm beside the pen
      this.hideCrosshair();
      this.hover = toMm(this.ports.view(), last);
      if (this.gesture?.pointer === 'none') this.extend(this.gesture, [last], keys);
    } else if (this.gesture?.pointer === id) this.extend(this.gesture, places, keys);
    else if (this.panner === id || this.pinched)
      movePicture(this.ports, pointer.at, last, [...this.pointers].find(([other]) => other !== id)?.[1].at);
    if (pointer !== undefined) pointer.at = last;
    this.ports.changed();
  }

  /** Handles a pointer that is released: its drawing is finished. */
  pointerUp(id: number, nowMs: number): void {
    const pointer = this.pointers.get(id);
    if (pointer === undefined) return;
    if (pointer.kind === 'pen') this.penUntilMs = nowMs + PALM_MS;
    this.pointers.delete(id);
    if (this.panner === id) this.panner = null;
    if (this.pointers.size === 0) this.pinched = false;
    if (this.gesture?.pointer === id) {
      this.hover = pointer.kind === 'touch' ? null : toMm(this.ports.view(), pointer.at);
      this.release(this.gesture, nowMs);
    }
    this.ports.changed();
  }

  /** Handles a pointer that the browser has cancelled: its drawing does not count. */
  pointerLost(id: number): void {
    if (!this.pointers.has(id)) return;
    if (this.gesture?.pointer === id) this.letGo();
    this.pointerUp(id, -Infinity);
  }

  /** Handles a pointer that leaves the arena. */
  pointerLeave(): void {
    this.hover = null;
    if (this.gesture?.pointer === 'none') backToCorners(this.gesture);
    this.ports.changed();
  }

  /** Drops the gesture. Returns whether there was one. */
  cancel(): boolean {
    if (this.gesture === null) return false;
    this.gesture = null;
    this.ports.changed();
    return true;
  }

  /** Finishes a drawing corner by corner with the corners that are set. */
  endChain(): void {
    const gesture = this.gesture;
    if (gesture === null || gesture.corners === 0) return;
    backToCorners(gesture);
    if (gesture.corners > 1) this.finish(gesture);
    else this.gesture = null;
    this.ports.changed();
  }

  /** Takes the corner that was set last back. */
  takeCornerBack(): void {
    if (this.gesture !== null && !takeCornerBack(this.gesture)) this.gesture = null;
    this.ports.changed();
  }

  /** Finishes what the keyboard or set corners have drawn, and forgets everything else: another tool is chosen. */
  reset(): void {
    this.endKeys();
    this.endChain();
    this.cancel();
    this.kept = [];
    this.hover = null;
    this.ports.changed();
  }

  /**
   * Moves the crosshair of the keyboard, world mm. While it is hidden, shows it at the whole cm nearest to `middle`
   * instead. Returns its place.
   */
  moveCrosshair(by: Vec, middle: Vec, fine: boolean): Vec {
    const from = this.keyAt;
    const to = intoArena(from ? plus(from, by) : { x: tens(middle.x), y: tens(middle.y) }, this.ports.arena());
    this.keyAt = to;
    this.hover = null;
    const gesture = this.gesture;
    if (gesture?.pointer === 'none') gesture.pointer = null; // the keyboard continues from the clicks
    if (gesture?.pointer === null) {
      goTo(gesture, to);
      gesture.free ||= fine;
    }
    this.ports.changed();
    return to;
  }

  /**
   * Handles a key that may belong to a number typed during the gesture: Enter ends it there, Escape returns to the
   * pointer. Returns true if it was used.
   */
  type(key: string): boolean {
    const gesture = this.gesture;
    if (gesture === null) return false;
    const isTyping = gesture.typed !== '';
    if (isTyping && key === 'Enter') this.finish(gesture);
    else if (isTyping && key === 'Escape') Object.assign(gesture, { typed: '', isStale: true });
    else if (!typeKey(gesture, key)) return false;
    this.ports.changed();
    return true;
  }

  /**
   * Begins a gesture at the crosshair, or ends it. Returns whether it draws now.
   *
   * @param drags a tool that puts things down with one press begins a drag instead
   */
  pressKey(middle: Vec, drags = false): boolean {
    const at = this.keyAt ?? this.moveCrosshair({ x: 0, y: 0 }, middle, false);
    const gesture = this.gesture;
    if (gesture === null) {
      this.kept = [];
      this.begin(null, at, { kind: 'mouse', free: false, adds: false });
      if (!drags && this.ports.tool()?.putsDown === true) this.endKeys();
    } else if (gesture.pointer === null) this.release(gesture);
    else if (gesture.pointer === 'none') this.endChain();
    this.ports.changed();
    return this.gesture !== null;
  }

  /** Hides the crosshair, which shows only as long as the arena has the keyboard. */
  blur(): void {
    this.hideCrosshair();
    this.ports.changed();
  }

  /** The current picture. Calls the tool at most once per change of the path. */
  picture(): SurfacePicture {
    const gesture = this.gesture;
    const crosshair = this.keyAt && { at: this.keyAt, isDown: gesture?.pointer === null };
    if (gesture === null) return { ...NOTHING, marks: this.hoverMarks(), crosshair, hover: this.hover };
    if (gesture.isStale && gesture.ink === null) this.ask(gesture);
    if (gesture.isStale) gesture.figures = figuresNow(gesture);
    gesture.isStale = false;
    return { ...pictureOf(gesture), crosshair };
  }

  private begin(
    pointer: number | null,
    at: Vec,
    press: Pick<SurfacePress, 'kind' | 'free' | 'adds' | 'keeps' | 'alt'>,
    nowMs = Infinity,
  ): void {
    const tool = this.ports.tool();
    if (tool === null) return;
    const context = this.ports.context();
    const { reachMm } = this;
    this.hover = null;
    if (this.gesture?.pointer === 'none' && pointer !== null) {
      Object.assign(this.gesture, { pointer, kind: press.kind, reachMm });
      goTo(this.gesture, at);
      return;
    }
    this.gesture = {
      ...{ pointer, tool, context, ...initialGesture(press, at, this.ports.isFree()) },
      reachMm: pointer === null ? Math.min(reachMm, KEY_REACH_MM) : reachMm,
      ink: tool.ink?.(context) ?? eraserInk(tool, context),
      isSecond: this.taps.isSecond(at, nowMs, reachMm),
    };
  }

  private extend(gesture: Gesture, places: readonly Vec[], keys: HeldKeys): void {
    const view = this.ports.view();
    for (const place of places) goTo(gesture, toMm(view, place));
    // Whether it adds to the selection was decided at the press.
    Object.assign(gesture, modifiersOf(keys, this.ports.isFree()), { isStale: true });
  }

  /** Finishes a gesture after a release or Enter, or continues it from a corner there. */
  private release(gesture: Gesture, nowMs?: number): void {
    if (!setCorner(gesture)) this.finish(gesture, nowMs);
  }

  /** Drops the current gesture; corners that are set stay. */
  private letGo(): void {
    if (this.gesture !== null && this.isChaining) backToCorners(this.gesture);
    else this.cancel();
  }

  private ask(gesture: Gesture): void {
    const { scene } = gesture.context;
    const edit = gesture.tool.edit(dragOf(gesture), gesture.context);
    gesture.edit = edit && withStuck(scene, edit);
    gesture.after = gesture.edit && applyEdit(scene, gesture.edit);
  }

  private finish(gesture: Gesture, nowMs = -Infinity): void {
    const { tool, context } = gesture;
    this.ask(gesture);
    this.gesture = null;
    const drag = dragOf(gesture);
    const opened = this.taps.opened(gesture, drag, nowMs);
    if (opened !== null) return this.ports.open(opened);
    // The measurement stays in sight until the next gesture.
    this.kept = (tool.marks?.(drag, context, true) ?? []).filter(({ type }) => type === 'measure');
    const selection = tool.select?.(drag, context, gesture.after ?? context.scene);
    const { reading } = figuresNow(gesture);
    if (gesture.edit !== null) this.ports.commit(gesture.edit, selection);
    else if (selection !== undefined) this.ports.select(selection);
    if (gesture.edit !== null && reading !== null) this.ports.done(reading);
  }

  private hoverMarks(): readonly Mark[] {
    const at = this.keyAt ?? this.hover;
    const tool = this.ports.tool();
    if (at === null) return [...this.kept, ...(tool?.marksAtRest?.(this.ports.context()) ?? [])];
    if (tool?.marks === undefined || this.pinched) return this.kept;
    const reachMm = this.keyAt === null ? this.reachMm : Math.min(this.reachMm, KEY_REACH_MM);
    const drag: Drag = { path: [at], free: this.ports.isFree(), adds: false, reachMm };
    return [...this.kept, ...tool.marks(drag, this.ports.context(), false)];
  }

  private hasPen(): boolean {
    return [...this.pointers.values()].some(({ kind }) => kind === 'pen');
  }

  private forgetTouches(): void {
    for (const [id, { kind }] of this.pointers) {
      if (kind !== 'touch') continue;
      if (this.gesture?.pointer === id) this.letGo();
      this.pointers.delete(id);
    }
    this.pinched = false;
  }

  /** Finishes a drawing by the keyboard: only Escape drops it. A line corner by corner can be continued with clicks. */
  private endKeys(): void {
    if (this.gesture?.pointer !== null) return;
    if (this.isChaining) backToCorners(this.gesture);
    else this.finish(this.gesture);
  }

  private hideCrosshair(): void {
    this.endKeys();
    this.keyAt = null;
  }
}

/** The nearest whole cm. */
const tens = (mm: number): number => Math.round(mm / 10) * 10;

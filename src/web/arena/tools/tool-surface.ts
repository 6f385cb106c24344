import type { Vec } from '#core/geometry';
import { noFigures } from '#editor/snap/figures';
import type { Reading } from '#editor/snap/reading';
import type { Drag, Mark, Opened, Selection, Tool, ToolContext } from '#editor/tools/tool';
import { applyEdit, type SceneEdit } from '#scene/edit';
import type { Scene } from '#scene/scene';
import {
  dragOf,
  figuresNow,
  toldBy,
  typeKey,
  type Gesture,
  type HeldKeys,
  type Ink,
  type PointerKind,
  type SurfacePress,
  type Told,
} from './gesture';
import { veilOf } from './eraser-veil';
import { TapMemory } from './tap-memory';
import { movePicture, type PicturePorts } from '../view/pinch';
import { toMm, type ArenaSize, type View } from '../view/view-transform';

/** What the surface sees and does. */
export interface SurfacePorts extends PicturePorts {
  readonly view: () => View;
  readonly arena: () => ArenaSize;
  /** The chosen tool, or `null` for none. */
  readonly tool: () => Tool | null;
  readonly context: () => ToolContext;
  /** The switch that turns snapping off. */
  readonly isFree: () => boolean;
  readonly commit: (edit: SceneEdit, select?: Selection) => void;
  readonly select: (selection: Selection) => void;
  /** A gesture has changed the course, to these figures. */
  readonly done: (reading: Reading) => void;
  /** A double tap opens what is inside a thing. */
  readonly open: (opened: Opened) => void;
  /** Something looks different now. */
  readonly changed: () => void;
}

/** What is to be seen of a tool at one moment. */
export interface SurfacePicture {
  /** The result of the gesture so far, and the course with it. */
  readonly edit: SceneEdit | null;
  readonly after: Scene | null;
  readonly ink: Ink | null;
  readonly marks: readonly Mark[];
  /** The crosshair of the keyboard, world mm, and whether it draws. */
  readonly crosshair: { readonly at: Vec; readonly isDown: boolean } | null;
  /** What is told beside the pointer: its place, world mm, and whether a finger covers it. */
  readonly told: Told | null;
  /** Where a finger draws, which covers what is under it; world mm. */
  readonly finger: Vec | null;
  /** Where the pointer is with nothing pressed, world mm. */
  readonly hover: Vec | null;
}

/** How near counts as on a thing, in px: half of a target. */
const REACH_PX: Readonly<Record<PointerKind, number>> = { mouse: 8, pen: 12, touch: 22 };

/** The crosshair goes in whole mm: what is nearer than this is meant. */
const KEY_REACH_MM = 9;

/** A hand that lies on the screen may lift a moment after the pen. */
const PALM_MS = 400;

/**
 * Turns pointers and keys over the arena into drags of the chosen tool, and their end into one edit. Gets events as
 * plain data, so that it can be tested without a browser.
 *
 * One finger, the pen or the first button uses the tool; two fingers always move and zoom the picture and drop what one
 * of them had begun. While a pen is down, touches are a resting hand.
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

  /** @param kind what will point, most likely */
  constructor(
    private readonly ports: SurfacePorts,
    private kind: PointerKind = 'mouse',
  ) {}

  /** How near counts as on a thing for what pointed last, in mm. */
  get reachMm(): number {
    return REACH_PX[this.kind] / this.ports.view().pxPerMm;
  }

  /** Whether a gesture is under way. */
  get isBusy(): boolean {
    return this.gesture !== null;
  }

  /** What the gesture would come to if it ended now; `null`: nothing. */
  editSoFar(): SceneEdit | null {
    const gesture = this.gesture;
    return gesture && gesture.tool.edit(dragOf(gesture), gesture.context);
  }

  /** Whether the pointer moves the picture. */
  get isPanning(): boolean {
    return this.panner !== null || this.pinched;
  }

  /** The figures of the gesture, or `null`. */
  get told(): Told | null {
    return this.gesture && toldBy(this.gesture);
  }

  /** Where the crosshair of the keyboard is, world mm, or `null` while it is hidden. */
  get crosshair(): Vec | null {
    return this.keyAt;
  }

  /**
   * A finger, pen or button goes down.
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
      this.cancel();
      this.pinched = kind === 'touch';
    } else if (press.pans) this.panner = id;
    else this.begin(id, toMm(this.ports.view(), at), press, nowMs);
    this.ports.changed();
  }

  /** A pointer moves, pressed or not, over these places (CSS px, oldest first). */
  pointerMove(id: number, places: readonly Vec[], keys: HeldKeys): void {
    const last = places[places.length - 1];
    const pointer = this.pointers.get(id);
    if (last === undefined) return;
    if (pointer === undefined) {
      if (this.pointers.size > 0) return; // a palm beside the pen
      this.hideCrosshair();
      this.hover = toMm(this.ports.view(), last);
    } else if (this.gesture?.pointer === id) this.extend(this.gesture, places, keys);
    else if (this.panner === id || this.pinched)
      movePicture(this.ports, pointer.at, last, [...this.pointers].find(([other]) => other !== id)?.[1].at);
    if (pointer !== undefined) pointer.at = last;
    this.ports.changed();
  }

  /** A pointer goes up: what it drew is done. */
  pointerUp(id: number, nowMs: number): void {
    const pointer = this.pointers.get(id);
    if (pointer === undefined) return;
    if (pointer.kind === 'pen') this.penUntilMs = nowMs + PALM_MS;
    this.pointers.delete(id);
    if (this.panner === id) this.panner = null;
    if (this.pointers.size === 0) this.pinched = false;
    if (this.gesture?.pointer === id) {
      this.hover = pointer.kind === 'touch' ? null : toMm(this.ports.view(), pointer.at);
      this.finish(this.gesture, nowMs);
    }
    this.ports.changed();
  }

  /** The browser takes a pointer away: what it drew does not count. */
  pointerLost(id: number): void {
    if (!this.pointers.has(id)) return;
    if (this.gesture?.pointer === id) this.cancel();
    this.pointerUp(id, -Infinity);
  }

  /** The pointer leaves the arena. */
  pointerLeave(): void {
    this.hover = null;
    this.ports.changed();
  }

  /** Drops the gesture. Returns whether there was one. */
  cancel(): boolean {
    if (this.gesture === null) return false;
    this.gesture = null;
    this.ports.changed();
    return true;
  }

  /** Forgets everything: another tool is chosen, or another course is open. */
  reset(): void {
    this.endKeys();
    this.cancel();
    this.kept = [];
    this.hover = null;
    this.ports.changed();
  }

  /** Moves the crosshair of the keyboard by mm; the first time it shows, it shows where it is. Returns where it is now. */
  moveCrosshair(by: Vec, middle: Vec, fine: boolean): Vec {
    const [width, height] = this.ports.arena();
    const from = this.keyAt;
    const step = (mm: number, side: number): number => Math.max(0, Math.min(side, mm));
    const to =
      from === null
        ? { x: step(tens(middle.x), width), y: step(tens(middle.y), height) }
        : { x: step(from.x + by.x, width), y: step(from.y + by.y, height) };
    this.keyAt = to;
    this.hover = null;
    const gesture = this.gesture;
    if (gesture?.pointer === null) {
      gesture.path.push(to);
      gesture.free ||= fine;
      gesture.isStale = true;
    }
    this.ports.changed();
    return to;
  }

  /**
   * A key is pressed that may belong to a number typed during the gesture: Enter ends it there, Escape goes back to the
   * pointer. Returns whether it was used.
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
    } else if (gesture.pointer === null) this.finish(gesture);
    this.ports.changed();
    return this.gesture !== null;
  }

  /** The crosshair shows only as long as the arena has the keyboard. */
  blur(): void {
    this.hideCrosshair();
    this.ports.changed();
  }

  /** What is to be seen now. Asks the tool at most once per change of the path. */
  picture(): SurfacePicture {
    const gesture = this.gesture;
    const crosshair = this.keyAt && { at: this.keyAt, isDown: gesture?.pointer === null };
    if (gesture === null) return { ...NOTHING, marks: this.hoverMarks(), crosshair, hover: this.hover };
    if (gesture.isStale && gesture.ink === null) this.ask(gesture);
    if (gesture.isStale) gesture.figures = figuresNow(gesture);
    gesture.isStale = false;
    const drag = dragOf(gesture);
    return {
      edit: gesture.edit,
      after: gesture.after,
      ink: gesture.ink && { ...gesture.ink, path: gesture.path },
      marks: [...gesture.figures.marks, ...(gesture.tool.marks?.(drag, gesture.context, true) ?? [])],
      told: toldBy(gesture),
      crosshair,
      finger: gesture.kind === 'touch' ? (gesture.path[gesture.path.length - 1] ?? null) : null,
      hover: null,
    };
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
    this.gesture = {
      pointer,
      kind: press.kind,
      tool,
      context,
      path: [at],
      reachMm: pointer === null ? Math.min(reachMm, KEY_REACH_MM) : reachMm,
      ink: tool.ink?.(context) ?? veilOf(tool, context),
      free: press.free || this.ports.isFree(),
      adds: press.adds,
      keeps: press.keeps === true,
      alt: press.alt === true,
      isSecond: this.taps.isSecond(at, nowMs, reachMm),
      edit: null,
      after: null,
      figures: noFigures,
      typed: '',
      isStale: true,
    };
  }

  private extend(gesture: Gesture, places: readonly Vec[], keys: HeldKeys): void {
    const view = this.ports.view();
    for (const place of places) {
      const at = toMm(view, place);
      const before = gesture.path[gesture.path.length - 1];
      if (before === undefined || before.x !== at.x || before.y !== at.y) gesture.path.push(at);
    }
    gesture.keeps = keys.keeps === true;
    gesture.alt = keys.alt === true;
    gesture.free = keys.free || this.ports.isFree(); // what it adds to was settled at the press
    gesture.isStale = true;
  }

  private ask(gesture: Gesture): void {
    gesture.edit = gesture.tool.edit(dragOf(gesture), gesture.context);
    gesture.after = gesture.edit && applyEdit(gesture.context.scene, gesture.edit);
  }

  private finish(gesture: Gesture, nowMs = -Infinity): void {
    const { tool, context } = gesture;
    this.ask(gesture);
    this.gesture = null;
    const drag = dragOf(gesture);
    const opened = this.taps.opened(gesture, drag, nowMs);
    if (opened !== null) return this.ports.open(opened);
    // What was measured stays in sight until the next gesture.
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
      if (this.gesture?.pointer === id) this.cancel();
      this.pointers.delete(id);
    }
    this.pinched = false;
  }

  /** What the keyboard has drawn is done: only Escape drops it. */
  private endKeys(): void {
    if (this.gesture?.pointer === null) this.finish(this.gesture);
  }

  private hideCrosshair(): void {
    this.endKeys();
    this.keyAt = null;
  }
}

const NOTHING: SurfacePicture = {
  edit: null,
  after: null,
  ink: null,
  marks: [],
  told: null,
  crosshair: null,
  finger: null,
  hover: null,
};

/** The nearest whole cm. */
const tens = (mm: number): number => Math.round(mm / 10) * 10;

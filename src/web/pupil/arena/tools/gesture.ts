import type { Vec } from '#core/geometry';
import { figuresOf, inkReading, noFigures, type Figures } from '#editor/snap/figures';
import type { Reading } from '#editor/snap/reading';
import { typedDrag, typedNumbers, typedText } from '#editor/snap/typed';
import type { Drag, Tool, ToolContext } from '#editor/tools/tool';
import type { SceneEdit } from '#scene/edit';
import type { PaintColor } from '#scene/paint/paint';
import type { Scene } from '#scene/scene';

/** The kind of pointer: fingers need more room around a thing than a mouse. */
export type PointerKind = 'mouse' | 'pen' | 'touch';

/** A pointer that is pressed. */
export interface SurfacePress {
  readonly id: number;
  /** CSS px on the canvas. */
  readonly at: Vec;
  readonly kind: PointerKind;
  /** Moves the picture with any tool: another button than the first, or the space bar is down. */
  readonly pans: boolean;
  readonly free: boolean;
  readonly adds: boolean;
  readonly keeps?: boolean;
  readonly alt?: boolean;
}

/** The modifier keys that a drag reads again with each movement. */
export type HeldKeys = Pick<SurfacePress, 'free' | 'keeps' | 'alt'>;

/** A line that is being drawn freely. */
export interface Ink {
  /** World mm; grows during the drag. */
  readonly path: readonly Vec[];
  readonly width: number;
  readonly color: PaintColor;
}

/** A tool's drag in progress. */
export interface Gesture {
  /** `null`: the keyboard. `'none'`: between two clicks of a line that is drawn corner by corner. */
  pointer: number | null | 'none';
  kind: PointerKind;
  readonly tool: Tool;
  readonly context: ToolContext;
  readonly path: Vec[];
  /** Number of places of the path that are set corners; 0: it is not drawn corner by corner. */
  corners: number;
  reachMm: number;
  readonly ink: Omit<Ink, 'path'> | null;
  free: boolean;
  readonly adds: boolean;
  keeps: boolean;
  alt: boolean;
  /** True if it began at the place of a tap that had ended shortly before. */
  readonly isSecond: boolean;
  edit: SceneEdit | null;
  after: Scene | null;
  figures: Figures;
  /** The numbers typed during the gesture; empty: none. */
  typed: string;
  /** True if the gesture has changed since the last call of the tool. */
  isStale: boolean;
}

/** Figures beside a place. */
export interface ShownFigures {
  /** `null`: there are no figures yet, only typed ones. */
  readonly reading: Reading | null;
  /** Numbers that are being typed; empty: none. */
  readonly typed: string;
  /** World mm. */
  readonly at: Vec;
  readonly isFinger: boolean;
}

/** The gesture as a tool sees it: the pointer's drag, or the one that leads to the typed numbers. */
export function dragOf({ path, free, adds, keeps, alt, reachMm, corners, typed, tool, context }: Gesture): Drag {
  const drag = { path, free, adds, keeps, alt, reachMm, ...(corners > 0 ? { corners } : {}) };
  return typed === '' ? drag : typedDrag(tool, drag, context, typedNumbers(typed));
}

/**
 * Handles a key that is pressed during a gesture. Returns true if it belongs to numbers; freehand drawing and drawing
 * corner by corner take none.
 */
export function typeKey(gesture: Gesture, key: string): boolean {
  const typed = gesture.ink === null && gesture.corners === 0 ? typedText(gesture.typed, key) : null;
  if (typed === null) return false;
  gesture.typed = typed;
  gesture.isStale = true;
  return true;
}

/** The gesture in figures. */
export const figuresNow = (gesture: Gesture): Figures =>
  gesture.ink !== null && gesture.tool.ink !== undefined
    ? { ...noFigures, reading: inkReading(gesture.path) }
    : figuresOf(gesture.edit, gesture.context, { tool: gesture.tool, drag: dragOf(gesture) });

/** The figures shown beside the pointer. */
export function toldBy({ figures: { reading }, path, kind, typed }: Gesture): ShownFigures | null {
  const at = path[path.length - 1];
  return at && (reading || typed !== '') ? { reading, typed, at, isFinger: kind === 'touch' } : null;
}

/** Place where a finger draws; `null`: nothing is pressed, or a finer pointer. */
export const fingerOf = ({ kind, pointer, path }: Gesture): Vec | null =>
  kind === 'touch' && typeof pointer === 'number' ? (path[path.length - 1] ?? null) : null;

/** Meaning of the held keys; `isFree`: the switch that turns snapping off. */
export const modifiersOf = ({ free, keeps, alt }: HeldKeys, isFree: boolean) => ({
  free: free || isFree,
  keeps: keeps === true,
  alt: alt === true,
});

/** The initial values of a gesture, whatever its tool. */
export const initialGesture = (
  press: Pick<SurfacePress, 'kind' | 'free' | 'adds' | 'keeps' | 'alt'>,
  at: Vec,
  isFree: boolean,
) => ({
  kind: press.kind,
  path: [at],
  corners: 0,
  ...modifiersOf(press, isFree),
  adds: press.adds,
  edit: null,
  after: null,
  figures: noFigures,
  typed: '',
  isStale: true,
});

/** The visible part of a gesture. */
export const pictureOf = (gesture: Gesture) => ({
  edit: gesture.edit,
  after: gesture.after,
  ink: gesture.ink && { ...gesture.ink, path: gesture.path },
  marks: [...gesture.figures.marks, ...(gesture.tool.marks?.(dragOf(gesture), gesture.context, true) ?? [])],
  told: toldBy(gesture),
  finger: fingerOf(gesture),
  hover: null,
});

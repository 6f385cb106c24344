import type { Vec } from '#core/geometry';
import { figuresOf, inkReading, noFigures, type Figures } from '#editor/snap/figures';
import type { Reading } from '#editor/snap/reading';
import { typedDrag, typedNumbers, typedText } from '#editor/snap/typed';
import type { Drag, Tool, ToolContext } from '#editor/tools/tool';
import type { SceneEdit } from '#scene/edit';
import type { Scene, StrokeColor } from '#scene/scene';

/** What points: fingers need more room around a thing than a mouse. */
export type PointerKind = 'mouse' | 'pen' | 'touch';

/** A pointer that goes down. */
export interface SurfacePress {
  readonly id: number;
  /** CSS px on the canvas. */
  readonly at: Vec;
  readonly kind: PointerKind;
  /** Moves the picture whatever the tool is: another button than the first, or the space bar is down. */
  readonly pans: boolean;
  readonly free: boolean;
  readonly adds: boolean;
  readonly keeps?: boolean;
  readonly alt?: boolean;
}

/** The keys that a drag asks for again with each movement. */
export type HeldKeys = Pick<SurfacePress, 'free' | 'keeps' | 'alt'>;

/** A line that is being drawn freely. */
export interface Ink {
  /** World mm; grows while the drag goes on. */
  readonly path: readonly Vec[];
  readonly width: number;
  readonly color: StrokeColor;
}

/** A drag of a tool that is under way. */
export interface Gesture {
  /** `null`: the keyboard. `'none'`: between two clicks of a line that is drawn corner by corner. */
  pointer: number | null | 'none';
  kind: PointerKind;
  readonly tool: Tool;
  readonly context: ToolContext;
  readonly path: Vec[];
  /** So many places of the path are corners that are set; 0: it is not drawn corner by corner. */
  corners: number;
  reachMm: number;
  readonly ink: Omit<Ink, 'path'> | null;
  free: boolean;
  readonly adds: boolean;
  keeps: boolean;
  alt: boolean;
  /** It began where and shortly after a tap ended. */
  readonly isSecond: boolean;
  edit: SceneEdit | null;
  after: Scene | null;
  figures: Figures;
  /** The numbers that are typed while it goes on; empty: none. */
  typed: string;
  /** The path has grown since the last call of the tool. */
  isStale: boolean;
}

/** Figures beside a place. */
export interface Told {
  /** `null`: nothing can be told yet, only typed. */
  readonly reading: Reading | null;
  /** Numbers that are being typed; empty: none. */
  readonly typed: string;
  /** World mm. */
  readonly at: Vec;
  readonly isFinger: boolean;
}

/** What a tool sees of a gesture: the pointer's drag, or the one that leads to the typed numbers. */
export function dragOf({ path, free, adds, keeps, alt, reachMm, corners, typed, tool, context }: Gesture): Drag {
  const drag = { path, free, adds, keeps, alt, reachMm, ...(corners > 0 ? { corners } : {}) };
  return typed === '' ? drag : typedDrag(tool, drag, context, typedNumbers(typed));
}

/**
 * A key is pressed while a gesture goes on. Returns whether it belongs to numbers; what is drawn freely or corner by corner takes none.
 */
export function typeKey(gesture: Gesture, key: string): boolean {
  const typed = gesture.ink === null && gesture.corners === 0 ? typedText(gesture.typed, key) : null;
  if (typed === null) return false;
  gesture.typed = typed;
  gesture.isStale = true;
  return true;
}

/** What a gesture amounts to in figures. */
export const figuresNow = (gesture: Gesture): Figures =>
  gesture.ink !== null && gesture.tool.ink !== undefined
    ? { ...noFigures, reading: inkReading(gesture.path) }
    : figuresOf(gesture.edit, gesture.context, { tool: gesture.tool, drag: dragOf(gesture) });

/** What is told beside the pointer. */
export function toldBy({ figures: { reading }, path, kind, typed }: Gesture): Told | null {
  const at = path[path.length - 1];
  return at && (reading || typed !== '') ? { reading, typed, at, isFinger: kind === 'touch' } : null;
}

/** Where a finger draws; `null`: nothing is pressed, or something finer. */
export const fingerOf = ({ kind, pointer, path }: Gesture): Vec | null =>
  kind === 'touch' && typeof pointer === 'number' ? (path[path.length - 1] ?? null) : null;

/** What the keys say that are held; `isFree`: the switch that turns snapping off. */
export const heldBy = ({ free, keeps, alt }: HeldKeys, isFree: boolean) => ({
  free: free || isFree,
  keeps: keeps === true,
  alt: alt === true,
});

/** What is the same at the beginning of each gesture. */
export const begun = (
  press: Pick<SurfacePress, 'kind' | 'free' | 'adds' | 'keeps' | 'alt'>,
  at: Vec,
  isFree: boolean,
) => ({
  kind: press.kind,
  path: [at],
  corners: 0,
  ...heldBy(press, isFree),
  adds: press.adds,
  edit: null,
  after: null,
  figures: noFigures,
  typed: '',
  isStale: true,
});

/** What is to be seen of a gesture. */
export const pictureOf = (gesture: Gesture) => ({
  edit: gesture.edit,
  after: gesture.after,
  ink: gesture.ink && { ...gesture.ink, path: gesture.path },
  marks: [...gesture.figures.marks, ...(gesture.tool.marks?.(dragOf(gesture), gesture.context, true) ?? [])],
  told: toldBy(gesture),
  finger: fingerOf(gesture),
  hover: null,
});

import type { Vec } from '#core/geometry';
import type { SceneEdit } from '#scene/edit';
import type { MoverWay } from '#scene/kinds/mover-way';
import type { PaintColor } from '#scene/paint/paint';
import type { Point, Scene, SceneObject, Zone } from '#scene/scene';
import type { ShapeName } from '#scene/shape/shape';

/**
 * The tools of the palette, and the one that bends a selected line. The hand is not among them: it reaches into the run,
 * never into the course.
 */
export type ToolId =
  'select' | 'points' | 'rotate' | 'pen' | 'eraser' | 'block' | 'wall' | 'maze' | 'zone' | 'label' | 'start' | 'ruler';

/** A gesture so far: a pointer that went down, or the crosshair of the keyboard. */
export interface Drag {
  /** World mm, not rounded; at least one. The first is where it began. */
  readonly path: readonly Vec[];
  /** No snapping, fine steps (the Ctrl or ⌘ key, or the switch beside the tool). */
  readonly free: boolean;
  /** Adds to the selection instead of making a new one (Shift, Ctrl or ⌘ at the press). */
  readonly adds: boolean;
  /** Keeps the proportions of what is sized, makes sides equally long (Shift while it is dragged); left out: no. */
  readonly keeps?: boolean;
  /** Copies what is moved, sizes or draws about the middle (Alt or Option while it is dragged); left out: no. */
  readonly alt?: boolean;
  /** How near counts as on a thing, in mm: larger for a finger than for a mouse, and when zoomed out. */
  readonly reachMm: number;
  /** Things that attract what is drawn or sized; left out: only the grid does. */
  readonly lure?: Lure | undefined;
  /**
   * Drawn corner by corner: so many places of `path` are corners that are set, one more is where the pointer is. Left
   * out: not begun by a tap.
   */
  readonly corners?: number;
}

/** Draws a coordinate onto a thing in reach; `null`: none is. */
export type Lure = (mm: number, axis: 'x' | 'y') => number | null;

/** The selection: objects of the course by id, and whether the robot's start is selected. */
export interface Selection {
  readonly ids: readonly string[];
  readonly robot: boolean;
}

export const nothingSelected: Selection = { ids: [], robot: false };

/**
 * How the pen draws. `free`: as drawn; `curve`: smoothed; `straight`: from start to end, snapped to 45°; `corners`: from
 * click to click; `arc`: from one place to another through a third; the others: round the rectangle that a drag spans.
 */
export const penShapes = ['free', 'curve', 'straight', 'corners', 'arc', 'circle', 'oval', 'rounded'] as const;
export type PenShape = (typeof penShapes)[number];

/** The options beside the tools. One record for all tools: each reads its own. */
export interface ToolOptions {
  readonly penWidth: number;
  readonly penColor: PaintColor;
  readonly penShape: PenShape;
  /** `all`: cuts strokes where it passes and takes everything else away; `lines`: strokes alone. */
  readonly eraser: 'all' | 'lines';
  readonly eraserWidth: number;
  readonly block: 'block' | 'fixed-block' | 'spikes' | 'mover';
  /** Movers are no polygons: they are rectangles then. */
  readonly blockShape: ShapeName;
  readonly blockSize: Point;
  /** Height of a new block, fixed block, mover or of new spikes, in mm; `null`: usual for its kind. */
  readonly blockHeight: number | null;
  /** Colour of a new block or fixed block; `null`: none. */
  readonly blockColor: PaintColor | null;
  /** The movement of a new mover. */
  readonly moverWay: MoverWay;
  readonly moverSpeed: number;
  /** Seconds that it waits at each of its stops. */
  readonly moverWait: number;
  /** Degrees per second that it turns; 0: what stays on its place turns all the same. */
  readonly moverSpin: number;
  readonly moverSpiked: boolean;
  readonly wallThickness: number;
  /** In mm; `null`: the usual one. */
  readonly wallHeight: number | null;
  /** Colour of a new wall; `null`: none. */
  readonly wallColor: PaintColor | null;
  /** Walls snap to 45° and to ends of other walls. */
  readonly wallSnaps: boolean;
  /** Side of a cell of the maze's grid in mm. */
  readonly mazeCell: number;
  readonly zone: Zone['type'] | 'paper';
  readonly zoneShape: ShapeName;
  /** Blocks that a new target wants; 0: the robot. */
  readonly zoneBlocks: number;
  /** Their colour; `null`: any. */
  readonly zoneBlockColor: PaintColor | null;
  readonly labelText: string;
  readonly labelHeight: number;
  /** Each tap adds a thing to the selection or takes it away: for fingers, which have no Shift key. */
  readonly several: boolean;
  /** The shape that catches things when a drag begins on the floor. */
  readonly catches: 'frame' | 'lasso';
}

/** The surroundings of a tool. */
export interface ToolContext {
  /** The course at the beginning of the drag. */
  readonly scene: Scene;
  readonly selection: Selection;
  readonly options: ToolOptions;
  /** Convex parts of the robot at scale 1 in its own frame, mm; empty: no robot. */
  readonly footprint: readonly (readonly Vec[])[];
}

/** Something visible while a tool is used that is not an object of the course. World mm. */
export type Mark =
  /** The frame that catches objects. */
  | { readonly type: 'frame'; readonly from: Vec; readonly to: Vec }
  /** The lasso, or the outline of a polygon so far; its end is joined to its beginning. */
  | { readonly type: 'lasso'; readonly path: readonly Vec[] }
  /** The ruler's line; the page writes length, angle, x and y beside it. */
  | { readonly type: 'measure'; readonly from: Vec; readonly to: Vec }
  /** A ring around a point: an end has snapped to it, or a tap on it ends a line. */
  | { readonly type: 'snap'; readonly at: Vec }
  /** A point of the line or polygon that is being bent; `isNew`: a new one can be drawn out of it there. */
  | { readonly type: 'point'; readonly at: Vec; readonly isNew: boolean }
  /** The area of the eraser. */
  | { readonly type: 'eraser'; readonly at: Vec; readonly radiusMm: number }
  /** An object that is about to be taken away. */
  | { readonly type: 'goes'; readonly object: SceneObject }
  /** A line along edges or middles that lie in line. */
  | { readonly type: 'guide'; readonly from: Vec; readonly to: Vec }
  /** The distance between two things, with its figure; `equal`: one of several that are the same. */
  | { readonly type: 'distance'; readonly from: Vec; readonly to: Vec; readonly equal: boolean }
  /** The grid on whose edges a maze is built, and the edge that a tap would change. */
  | { readonly type: 'grid'; readonly cellMm: number; readonly edge: readonly [Vec, Vec] | null };

/** A point of the selection that can be grabbed. */
export interface Handle {
  readonly kind: 'rotate' | 'from' | 'to' | 'size' | 'point' | 'add';
  /** World mm. */
  readonly at: Vec;
  /**
   * Place of a `size` handle in the thing's own frame: −1, 0 or 1 along its x and its y. Left out for all other
   * handles.
   */
  readonly side?: Point;
  /** The object, of several the first, or `null` for the robot. */
  readonly id: string | null;
  /** Index: of a `point` among the points of its object; of an `add` the index that the new point will have. */
  readonly index?: number;
}

/** A turn about a place, counter-clockwise. */
export interface Turn {
  readonly byDeg: number;
  readonly about: Vec;
}

/**
 * One tool: a function from a drag to one edit. A tap is a drag with one place. Tools keep nothing: the same drag in the
 * same context gives the same edit.
 */
export interface Tool {
  readonly id: ToolId;
  /** It puts things down: one press of Enter does what a tap does, and with Shift it begins a drag. */
  readonly putsDown?: true;
  /** CSS cursor over the floor. */
  readonly cursor: string;
  /**
   * The result of the drag so far, or `null` for nothing (yet). Called and shown on every move; the last is the edit.
   */
  edit(drag: Drag, context: ToolContext): SceneEdit | null;
  /**
   * For tools that draw freely: the ink along the path while it is drawn, which may have many thousand points. `edit`
   * is then called only at the end. `null`: `edit` shows it.
   */
  ink?(context: ToolContext): { readonly width: number; readonly color: PaintColor } | null;
  /**
   * For tools that draw corner by corner: whether a drag goes on when the pointer is let go, with its place as the next
   * corner. Left out or `false`: then it is done.
   */
  goesOn?(drag: Drag, context: ToolContext): boolean;
  /** Additional marks; `drag` is a single place while the pointer only hovers. */
  marks?(drag: Drag, context: ToolContext, isDown: boolean): readonly Mark[];
  /** Marks shown while the tool is chosen and nothing points: fingers never hover. */
  marksAtRest?(context: ToolContext): readonly Mark[];
  /** How the drag turns things; `null` or left out: it does not turn them. */
  turns?(drag: Drag, context: ToolContext): Turn | null;
  /** The selection after the drag; left out: as before. `after` is the course with the edit applied. */
  select?(drag: Drag, context: ToolContext, after: Scene): Selection;
  /** The thing that a double tap or click opens there; left out, or `null`: it is a second tap like any other. */
  opens?(drag: Drag, context: ToolContext): Opened | null;
}

/**
 * A thing that can be opened to change its inside: a thing in a group, the words of a label, the points of a line or
 * polygon.
 */
export interface Opened {
  readonly part: 'thing' | 'words' | 'points';
  readonly id: string;
}

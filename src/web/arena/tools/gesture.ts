import type { Vec } from '#core/geometry';
import { figuresOf, inkReading, type Figures } from '#editor/snap/figures';
import type { Reading } from '#editor/snap/reading';
import type { Drag, Tool, ToolContext } from '#editor/tools/tool';
import type { SceneEdit } from '#scene/edit';
import type { Scene, StrokeColor } from '#scene/scene';

/** What points: fingers need more room around a thing than a mouse. */
export type PointerKind = 'mouse' | 'pen' | 'touch';

/** A line that is being drawn freely. */
export interface Ink {
  /** World mm; grows while the drag goes on. */
  readonly path: readonly Vec[];
  readonly width: number;
  readonly color: StrokeColor;
}

/** A drag of a tool that is under way. */
export interface Gesture {
  /** `null`: the keyboard. */
  readonly pointer: number | null;
  readonly kind: PointerKind;
  readonly tool: Tool;
  readonly context: ToolContext;
  readonly path: Vec[];
  readonly reachMm: number;
  readonly ink: Omit<Ink, 'path'> | null;
  free: boolean;
  readonly adds: boolean;
  edit: SceneEdit | null;
  after: Scene | null;
  figures: Figures;
  /** The path has grown since the last call of the tool. */
  isStale: boolean;
}

/** Figures beside a place. */
export interface Told {
  readonly reading: Reading;
  /** World mm. */
  readonly at: Vec;
  readonly isFinger: boolean;
}

/** What a tool sees of a gesture. */
export const dragOf = ({ path, free, adds, reachMm }: Gesture): Drag => ({ path, free, adds, reachMm });

/** What a gesture amounts to in figures. */
export const figuresNow = (gesture: Gesture): Figures =>
  gesture.ink !== null && gesture.tool.ink !== undefined
    ? { reading: inkReading(gesture.path), marks: [] }
    : figuresOf(gesture.edit, gesture.context, { tool: gesture.tool, drag: dragOf(gesture) });

/** What is told beside the pointer. */
export function toldBy({ figures: { reading }, path, kind }: Gesture): Told | null {
  const at = path[path.length - 1];
  return reading && at ? { reading, at, isFinger: kind === 'touch' } : null;
}

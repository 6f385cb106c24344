import type { Vec } from '#core/geometry';
import { applyEdit } from '#scene/edit';
import { defaultScene, type Point, type Scene, type SceneObject } from '#scene/scene';
import { usualToolOptions } from '../tools/tool-options';
import {
  nothingSelected,
  type Drag,
  type Selection,
  type Tool,
  type ToolContext,
  type ToolOptions,
} from '../tools/tool';

/** A robot for tests: 100 mm long and 60 mm wide, 60 mm of it in front of the axle. */
export const footprint: readonly (readonly Vec[])[] = [
  [
    { x: -40, y: -30 },
    { x: 60, y: -30 },
    { x: 60, y: 30 },
    { x: -40, y: 30 },
  ],
];

/** The usual arena, 1200 × 900 mm, with the robot at [600, 450] and some objects. */
export const course = (...objects: readonly SceneObject[]): Scene => ({ ...defaultScene(), objects });

/** A wall for tests. */
export const wall = (id: string, from: Point, to: Point): SceneObject => ({
  type: 'wall',
  id,
  from,
  to,
  thickness: 10,
});

/** A block of 50 × 50 mm for tests. */
export const block = (id: string, at: Point, eighths = 0): SceneObject => ({
  type: 'block',
  id,
  at,
  size: [50, 50],
  angle: 45 * eighths,
});

/** A black stroke of 20 mm for tests. */
export const stroke = (id: string, ...points: readonly Point[]): SceneObject => ({
  type: 'stroke',
  id,
  points,
  width: 20,
  color: 'black',
});

/** A target of 200 × 200 mm for tests. */
export const target = (id: string, at: Point): SceneObject => ({
  type: 'target',
  id,
  at,
  size: [200, 200],
  angle: 0,
  round: false,
  number: 0,
  blocks: 0,
});

/** A checkpoint of 150 × 150 mm for tests. */
export const checkpoint = (id: string, at: Point, number: number): SceneObject => ({
  type: 'checkpoint',
  id,
  at,
  size: [150, 150],
  angle: 0,
  round: false,
  number,
  blocks: 0,
});

/** A mover for tests. */
export const mover = (id: string, at: Point, to: Point): SceneObject => ({
  type: 'mover',
  id,
  at,
  to,
  size: [50, 50],
  angle: 0,
  speed: 100,
  spiked: false,
});

/** The surroundings of a tool, with the usual options. */
export const contextOf = (
  scene: Scene,
  options: Partial<ToolOptions> = {},
  selection: Selection = nothingSelected,
): ToolContext => ({ scene, selection, options: { ...usualToolOptions, ...options }, footprint });

/** A drag along some places with a mouse: 8 mm count as near. */
export const drag = (...path: readonly Point[]): Drag => ({
  path: path.map(([x, y]) => ({ x, y })),
  free: false,
  adds: false,
  reachMm: 8,
});

/** Taps from corner to corner; the last one is that under the pointer. */
export const taps = (...places: readonly Point[]): Drag => ({ ...drag(...places), corners: places.length - 1 });

/** The same without snapping. */
export const freely = (one: Drag): Drag => ({ ...one, free: true });

/** The course after a tool was used; the same course when it did nothing. */
export function used(tool: Tool, one: Drag, context: ToolContext): Scene {
  const edit = tool.edit(one, context);
  return edit ? applyEdit(context.scene, edit) : context.scene;
}

/** The objects that an edit added to a course. */
export const newObjects = (before: Scene, after: Scene): readonly SceneObject[] =>
  after.objects.filter((object) => !before.objects.includes(object));

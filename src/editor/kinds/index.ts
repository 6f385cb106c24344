import type { Vec } from '#core/geometry';
import { boundsOf } from '#scene/kinds/index';
import { boundsMeet, boundsOfOutline, type Bounds, type Outline } from '#scene/outline';
import type { Point, Scene, SceneObject } from '#scene/scene';
import { freeIds } from '../ids';
import { grown } from '../bounds';
import { noteMove } from '../moves';
import type { Field } from '../object-fields';
import type { ToolOptions } from '../tools/tool';
import { block, fixedBlock, spikes } from './block';
import type { EditorKind } from './kind';
import { barrier } from './barrier';
import { label } from './label';
import { lamp } from './lamp';
import { tag } from './tag';
import { tunnel } from './tunnel';
import { mover } from './mover';
import { paper } from './paper';
import { start } from './start';
import { stroke } from './stroke';
import { wall } from './wall';
import { checkpoint, forbidden, target } from './zone';

/** Every kind of object by its type. */
export const editorKinds: Readonly<Record<SceneObject['type'], EditorKind>> = {
  wall,
  block,
  'fixed-block': fixedBlock,
  stroke,
  target,
  checkpoint,
  forbidden,
  paper,
  spikes,
  mover,
  lamp,
  barrier,
  tunnel,
  tag,
  label,
  start,
};

/** The kind of an object. */
export const kindOf = ({ type }: Pick<SceneObject, 'type'>): EditorKind => editorKinds[type];

/** An object moved by whole mm; the caller sees to it that it stays within what a course may hold. */
export const movedBy = (object: SceneObject, dx: number, dy: number): SceneObject =>
  noteMove(object, kindOf(object).moved(object, dx, dy), dx, dy);

/** The place of an object in its number fields; of a line its start. */
export const placeOf = (object: SceneObject): Point => kindOf(object).place(object);

/** The middle that an object turns about. */
export const middleOf = (object: SceneObject): Vec => kindOf(object).middle(object);

/** Distance of a place from an object in mm, at most `reachMm`; 0 on it, `null` if it is farther away. */
export function distanceTo(object: SceneObject, place: Vec, reachMm: number): number | null {
  if (!holds(grown(boundsOf(object), reachMm), place)) return null;
  const mm = kindOf(object).distanceMm(object, place);
  return mm <= reachMm ? mm : null;
}

const holds = ({ minX, minY, maxX, maxY }: Bounds, { x, y }: Vec): boolean =>
  x >= minX && x <= maxX && y >= minY && y <= maxY;

/** True if an object has a place in common with a convex outline (also a straight piece of two places); the edge counts. */
export const meets = (object: SceneObject, outline: Outline, around: Bounds = boundsOfOutline(outline)): boolean =>
  boundsMeet(boundsOf(object), around) && kindOf(object).meets(object, outline, around);

/** The fields of an object, in the order of a list. */
export const fieldsOf = (object: SceneObject): readonly Field<SceneObject>[] => kindOf(object).fields(object);

/** A new object in the size and look that the tools are set to; `null`: the course has no room for it. */
export const newObject = (
  scene: Scene,
  type: SceneObject['type'],
  at: Point,
  options: ToolOptions,
): SceneObject | null => editorKinds[type].made(freeIds(scene)(type), at, scene, options);

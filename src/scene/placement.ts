import { radOf } from '#core/angle';
import { exactCos, exactSin } from '#core/exact-math';
import type { Vec } from '#core/geometry';
import { kindOf, solidParts } from './kinds/index';
import { boundsOfOutline, movedOutline, overlapMm, type Outline } from './outline';
import type { SceneProblem } from './problem';
import type { Point, RobotStart, Scene, SceneObject } from './scene';

/** Bodies may overlap by this much without a complaint: the numbers of a scene are whole mm. */
const TOLERANCE_MM = 1;

/**
 * The problem of the robot's start, or none: not wholly inside the arena, or inside something solid.
 *
 * @param footprint convex parts of the robot at scale 1, in its own frame (x forward, y left, origin mid-axle); empty:
 *   none
 */
export function placementProblems(scene: Scene, footprint: readonly Outline[]): readonly SceneProblem[] {
  const parts = robotOutlines(scene.robot, footprint);
  const outside = outsideProblem(scene, parts);
  if (outside) return [outside];
  for (const [index, object] of scene.objects.entries()) {
    const solids = solidParts(object);
    if (parts.some((part) => solids.some((solid) => overlapMm(part, solid) > TOLERANCE_MM)))
      return [insideProblem(scene.robot, object, index)];
  }
  return [];
}

/** The parts of a robot at its start, in world mm. */
export function robotOutlines(
  { at, heading, scale }: Pick<RobotStart, 'at' | 'heading' | 'scale'>,
  footprint: readonly Outline[],
): readonly Outline[] {
  const headingRad = radOf(heading);
  const direction = { x: exactCos(headingRad), y: exactSin(headingRad) };
  return footprint.map((part) => {
    const scaled = part.map(({ x, y }) => ({ x: x * scale, y: y * scale }));
    return movedOutline(scaled, { x: at[0], y: at[1] }, direction);
  });
}

/**
 * The place nearest to the robot's that has all of its body inside the arena, in whole mm; in an arena that is too small
 * for it, the place where it sticks out as little as can be.
 *
 * @param footprint convex parts of the robot at scale 1 in its own frame; empty: only its origin is kept inside
 */
export function placeInside(robot: RobotStart, arena: Point, footprint: readonly Outline[]): Point {
  const parts = robotOutlines({ ...robot, at: [0, 0] }, footprint);
  const body = boundsOfOutline(parts.length === 0 ? [{ x: 0, y: 0 }] : parts.flat());
  return [
    coordinateInside(robot.at[0], body.minX, body.maxX, arena[0]),
    coordinateInside(robot.at[1], body.minY, body.maxY, arena[1]),
  ];
}

function coordinateInside(at: number, min: number, max: number, length: number): number {
  const least = Math.ceil(-min - ROUNDING_MM);
  const most = Math.floor(length - max + ROUNDING_MM);
  if (least > most) return Math.round((length - max - min) / 2) + 0;
  return Math.min(most, Math.max(least, Math.round(at))) + 0;
}

/** Rounding errors of a rotation are smaller than this. */
const ROUNDING_MM = 1e-6;

function outsideProblem(scene: Scene, parts: readonly Outline[]): SceneProblem | null {
  const [width, height] = scene.size;
  const isInside = ({ x, y }: Vec): boolean =>
    x >= -TOLERANCE_MM && y >= -TOLERANCE_MM && x <= width + TOLERANCE_MM && y <= height + TOLERANCE_MM;
  if (parts.every((part) => part.every(isInside))) return null;
  const [x, y] = scene.robot.at;
  return {
    code: 'robot-outside',
    path: 'robot.at',
    value: `[${x}, ${y}]`,
    params: { x, y, width, height },
    message: `robot.at: at [${x}, ${y}] the robot is not wholly inside the arena of ${width} × ${height} mm. Move it inwards.`,
  };
}

function insideProblem(robot: RobotStart, object: SceneObject, index: number): SceneProblem {
  const [x, y] = robot.at;
  const kind = kindOf(object).name;
  return {
    code: 'robot-inside',
    path: 'robot.at',
    value: `[${x}, ${y}]`,
    params: { x, y, kind, id: object.id, place: `objects[${index}]` },
    message: `robot.at: at [${x}, ${y}] the robot stands inside the ${kind} "${object.id}" (objects[${index}]). Move one of them.`,
  };
}

import type { Vec } from '#core/geometry';
import { exactCos, exactSin } from '#core/exact-math';
import type { SceneProblem } from './problem';
import type { Block, RobotStart, Scene, SceneObject, Wall } from './scene';

/** A convex outline in mm, counter-clockwise or clockwise. */
export type Outline = readonly Vec[];

/**
 * What every robot covers at least, in its own frame (x forward, y left, origin mid-axle): used where the robot type
 * is not known yet. Chosen: the Maqueen Lite's body without bumper corners, 2 mm smaller all around.
 */
export const smallestFootprint: readonly Outline[] = [
  [
    { x: -20, y: -33 },
    { x: 40, y: -33 },
    { x: 40, y: 33 },
    { x: -20, y: 33 },
  ],
];

/** Bodies may overlap by so much without being called inside each other: the figures of a scene are whole mm. */
const TOLERANCE_MM = 1;

/**
 * What is wrong with where the robot starts: outside the arena, or inside a wall or block.
 *
 * @param footprint convex parts of the robot at scale 1, in its own frame
 */
export function placementProblems(
  scene: Scene,
  footprint: readonly Outline[] = smallestFootprint,
): readonly SceneProblem[] {
  const parts = footprint.map((part) => placed(part, scene.robot));
  const outside = outsideProblem(scene, parts);
  if (outside) return [outside];
  for (const [index, object] of scene.objects.entries()) {
    const solid = solidOutline(object);
    if (solid && parts.some((part) => overlap(part, solid) > TOLERANCE_MM))
      return [insideProblem(scene.robot, object, index)];
  }
  return [];
}

/** The outline of what a robot bumps into, in world mm; `null` for what lies flat on the floor. */
export function solidOutline(object: SceneObject): Outline | null {
  switch (object.type) {
    case 'wall':
      return wallOutline(object);
    case 'block':
    case 'fixed-block':
      return blockOutline(object);
    case 'stroke':
      return null;
  }
}

function wallOutline({ from, to, thickness }: Wall): Outline {
  const dx = to[0] - from[0];
  const dy = to[1] - from[1];
  const half = thickness / 2 / lengthOf(dx, dy);
  const acrossX = -dy * half;
  const acrossY = dx * half;
  return [
    { x: from[0] - acrossX, y: from[1] - acrossY },
    { x: to[0] - acrossX, y: to[1] - acrossY },
    { x: to[0] + acrossX, y: to[1] + acrossY },
    { x: from[0] + acrossX, y: from[1] + acrossY },
  ];
}

function blockOutline({ at, size, turn }: Block): Outline {
  const x = size[0] / 2;
  const y = size[1] / 2;
  const corners = [
    { x: -x, y: -y },
    { x, y: -y },
    { x, y },
    { x: -x, y },
  ];
  return moved(corners, { x: at[0], y: at[1] }, (turn * Math.PI) / 4);
}

function placed(part: Outline, robot: RobotStart): Outline {
  const scaled = part.map(({ x, y }) => ({ x: x * robot.scale, y: y * robot.scale }));
  return moved(scaled, { x: robot.at[0], y: robot.at[1] }, (robot.heading * Math.PI) / 180);
}

function moved(outline: Outline, by: Vec, angleRad: number): Outline {
  const cos = exactCos(angleRad);
  const sin = exactSin(angleRad);
  return outline.map(({ x, y }) => ({ x: by.x + x * cos - y * sin, y: by.y + x * sin + y * cos }));
}

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
  const kind = object.type === 'wall' ? 'wall' : 'block';
  return {
    code: 'robot-inside',
    path: 'robot.at',
    value: `[${x}, ${y}]`,
    params: { x, y, kind, id: object.id, place: `objects[${index}]` },
    message: `robot.at: at [${x}, ${y}] the robot stands inside the ${kind} "${object.id}" (objects[${index}]). Move one of them.`,
  };
}

/** How deep two convex outlines overlap in mm; 0 or less when some line parts them (separating axis theorem). */
function overlap(a: Outline, b: Outline): number {
  let depth = Infinity;
  for (const outline of [a, b]) {
    for (const [index, corner] of outline.entries()) {
      const next = outline[(index + 1) % outline.length] ?? corner;
      const length = lengthOf(next.x - corner.x, next.y - corner.y);
      if (length === 0) continue;
      const axis = { x: (corner.y - next.y) / length, y: (next.x - corner.x) / length };
      const [minA, maxA] = extent(a, axis);
      const [minB, maxB] = extent(b, axis);
      depth = Math.min(depth, maxA - minB, maxB - minA);
    }
  }
  return depth;
}

function extent(outline: Outline, axis: Vec): readonly [number, number] {
  const along = outline.map(({ x, y }) => x * axis.x + y * axis.y);
  return [Math.min(...along), Math.max(...along)];
}

const lengthOf = (x: number, y: number): number => Math.sqrt(x * x + y * y);

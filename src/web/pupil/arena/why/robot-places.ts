import type { Pose, Vec } from '#core/geometry';
import type { Output } from '#simulation/causes/output';
import { toLocal } from '../hand/hit-test';
import type { Box, RobotDrawing, Spot } from '../robot/robot-drawing';

/** The parts of a drawing that a program sets. */
export type DrawnParts = Pick<RobotDrawing, 'wheels' | 'leds' | 'lamps' | 'rgb' | 'display'>;

/** A robot in the arena. */
export interface DrawnRobot {
  readonly pose: Pose;
  readonly scale: number;
  /** Its outline, robot frame, mm. */
  readonly outlineMm: readonly (readonly Vec[])[];
  /** `null`: its drawing is not loaded yet. */
  readonly parts: DrawnParts | null;
}

/**
 * Finds the part of a robot at a place: the nearest light, wheel or display within reach, else the robot.
 *
 * @param reachMm distance that counts as on it
 * @returns `null`: the robot is elsewhere
 */
export function partAt(pointMm: Vec, robot: DrawnRobot, reachMm: number): Output | 'robot' | null {
  const local = toLocal(robot.pose, pointMm);
  const at = { x: local.x / robot.scale, y: local.y / robot.scale };
  const reach = reachMm / robot.scale;
  const near = robot.parts === null ? null : drawnAt({ x: -at.y, y: -at.x }, robot.parts, reach);
  if (near !== null) return near;
  return robot.outlineMm.some((corners) => isIn(at, corners, reach)) ? 'robot' : null;
}

/** @param at in the drawing's frame */
function drawnAt(at: Vec, { wheels, leds, lamps, rgb, display }: DrawnParts, reach: number): Output | null {
  const colours = ({ onTop }: { readonly onTop: boolean }): readonly (readonly [Output, number])[] =>
    spots(
      rgb.map((light) => (light.isOnTop === onTop ? light : null)),
      rgb.map((_, place): Output => `color-${place}`),
      at,
    );
  const parts: readonly (readonly [Output, number])[] = [
    ...spots([leds.left ?? lamps.left, leds.right ?? lamps.right], ['light-left', 'light-right'], at),
    ...colours({ onTop: true }),
    ...[wheels.left, wheels.right].flatMap((box, side): readonly (readonly [Output, number])[] =>
      box === null ? [] : [[side === 0 ? 'wheel-left' : 'wheel-right', awayFrom(at, box)]],
    ),
    ...display.map((box): readonly [Output, number] => ['display', awayFrom(at, box)]),
    // Below the body: parts above them have priority.
    ...colours({ onTop: false }),
  ];
  const [nearest] = [...parts].sort(([, one], [, other]) => one - other);
  return nearest !== undefined && nearest[1] <= reach ? nearest[0] : null;
}

const spots = (all: readonly (Spot | null)[], outputs: readonly Output[], at: Vec): (readonly [Output, number])[] =>
  all.flatMap((spot, place) => {
    const output = outputs[place];
    if (spot === null || output === undefined) return [];
    return [[output, Math.max(0, Math.hypot(at.x - spot.x, at.y - spot.y) - spot.radius)] as const];
  });

function awayFrom(at: Vec, { x, y, width, height }: Box): number {
  const [dx, dy] = [Math.max(x - at.x, 0, at.x - x - width), Math.max(y - at.y, 0, at.y - y - height)];
  return Math.hypot(dx, dy);
}

/** Within a convex outline (counter-clockwise), or as near as `reach` to each edge's line. */
const isIn = (at: Vec, corners: readonly Vec[], reach: number): boolean =>
  corners.every((from, place) => {
    const to = corners[(place + 1) % corners.length] ?? from;
    const [dx, dy] = [to.x - from.x, to.y - from.y];
    return dx * (at.y - from.y) - dy * (at.x - from.x) >= -reach * Math.hypot(dx, dy);
  });

import type { Pose, Vec } from '#core/geometry';
import type { RobotStart } from '#scene/scene';
import { defaultScene } from '#scene/scene';
import type { Hardware } from '#simulation/hardware';
import { memoOf } from '#core/memo';
import type { ArenaRobot, RobotLook } from '../model/arena-model';
import { bumperAtStart, robotAtStart } from '../picture/arranged';
import { attachmentsAtStart } from '../robot/draw-attachments';

/** A robot of a device that is not shown, at one moment. */
export interface OtherNow {
  readonly robot: ArenaRobot;
  readonly scale: number;
  /** The display of its board. */
  readonly display: readonly number[];
}

/** A robot where it starts, with everything off. */
export function atStart(start: RobotStart, { robot, options }: Hardware): OtherNow {
  const carried = { attachments: attachmentsAtStart(robot?.mountMm ?? null, options), bumper: bumperAtStart(options) };
  return { robot: robotAtStart({ ...defaultScene(), robot: start }, carried), scale: start.scale, display: [] };
}

/** A circle around a robot. */
export interface Around {
  readonly atMm: Vec;
  readonly radiusMm: number;
}

/** The circle around a robot's body, about the middle of its outline. */
export function circleAround(pose: Pose, body: RobotLook['body'], scale: number): Around {
  const { x, y, radius } = ownCircle(body);
  const [cos, sin] = [Math.cos(pose.headingRad), Math.sin(pose.headingRad)];
  return {
    atMm: { x: pose.xMm + scale * (x * cos - y * sin), y: pose.yMm + scale * (x * sin + y * cos) },
    radiusMm: scale * radius,
  };
}

/** The circle in the robot's own frame, in mm; measured once, as it is needed many times a frame. */
const ownCircle = memoOf((body: RobotLook['body']) => {
  const corners = body.outlineMm.flat();
  const middle = (axis: 'x' | 'y'): number => {
    const all = corners.map((corner) => corner[axis]);
    return (Math.min(...all) + Math.max(...all)) / 2;
  };
  const [x, y] = [middle('x'), middle('y')];
  return { x, y, radius: Math.max(...corners.map((corner) => Math.hypot(corner.x - x, corner.y - y))) };
});

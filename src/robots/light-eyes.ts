import type { Side } from '#devices/dc-motor';
import type { Vec } from '#core/geometry';
import type { Facing } from '#world/light/light';

/** A light sensor of a robot, in the robot frame. */
export interface LightEye {
  readonly atMm: Vec;
  readonly facing: Facing;
}

/** Sine and cosine of 30°: how far the sensors are turned outwards from straight up. Chosen: programs steer by their difference. */
const OUTWARDS = 0.5;
const UPWARDS = 0.8660254037844386;

/** The two light sensors of a robot, looking up and outwards. @param leftMm the left one; the right one mirrors it */
export const lightEyes = ({ x, y }: Vec): Readonly<Record<Side, LightEye>> => ({
  left: { atMm: { x, y }, facing: { x: 0, y: OUTWARDS, z: UPWARDS } },
  right: { atMm: { x, y: -y }, facing: { x: 0, y: -OUTWARDS, z: UPWARDS } },
});

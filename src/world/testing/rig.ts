import type { Pose } from '#core/geometry';
import type { Chassis, ChassisType } from '../chassis';
import type { DriveLaw } from '../drive-law';
import { STEP_S } from '../step';
import { createWorld } from '../world';
import type { World } from '../world';

/** The fitted law of a Maqueen Lite with motors of 3 N, which is what the tests of this room drive. */
export const LITE_DRIVE: DriveLaw = {
  v0MmPerS: 387,
  coulomb: 0.0296,
  viscous: 0.1,
  yawResistance: 0.0372,
  stallForceN: 3,
  lagS: 0.06,
};

/** A robot of about the Lite's size and weight: a box of 81 × 85 mm with the axle 22 mm from its rear. */
export const testChassis = (drive: Partial<DriveLaw> = {}): ChassisType => ({
  outlineMm: [
    [
      { x: -22, y: -40 },
      { x: 59, y: -40 },
      { x: 59, y: 40 },
      { x: -22, y: 40 },
    ],
  ],
  massG: 150,
  centreOfMassMm: { x: 12, y: 0 },
  castorMm: { x: 45, y: 0 },
  wheels: [
    { atMm: { x: 0, y: 35 }, radiusMm: 21.5, gripMu: 0.8 },
    { atMm: { x: 0, y: -35 }, radiusMm: 21.5, gripMu: 0.8 },
  ],
  drive: { ...LITE_DRIVE, ...drive },
});

/** An arena with one robot in it, and what tests do with it. */
export interface Rig {
  readonly world: World;
  readonly robot: Chassis;
  /** Sets both duties, in bytes of 255 as the robot's controller takes them, and lets the time pass. */
  drive(leftByte: number, rightByte: number, seconds: number): void;
}

/** Makes an arena of 4 × 4 m (or as asked) with a robot. */
export function createRig(
  start: Pose = { xMm: 2000, yMm: 2000, headingRad: 0 },
  type: ChassisType = testChassis(),
  size = { widthMm: 4000, heightMm: 4000 },
): Rig {
  const world = createWorld(size);
  const robot = world.addChassis(type, start);
  return {
    world,
    robot,
    drive(leftByte, rightByte, seconds) {
      robot.setDuty(0, leftByte / 255);
      robot.setDuty(1, rightByte / 255);
      const steps = Math.round(seconds / STEP_S);
      for (let step = 0; step < steps; step++) world.step();
    },
  };
}

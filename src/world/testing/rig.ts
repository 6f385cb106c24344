import type { Pose } from '#core/geometry';
import type { Chassis, ChassisType } from '../chassis';
import type { DriveLaw } from '../drive-law';
import { STEP_S } from '../step';
import { createWorld } from '../world';
import type { World } from '../world';

/** The drive law of this room's tests: much like a Maqueen Lite, with motors of 3 N, without breakaway friction. */
export const LITE_DRIVE: DriveLaw = {
  v0MmPerS: 387,
  coulomb: 0.0296,
  viscous: 0.1,
  yawResistance: 0.08,
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
  heightMm: 85,
  massG: 150,
  centreOfMassMm: { x: 12, y: 0 },
  castorMm: { x: 45, y: 0 },
  wheels: [
    { atMm: { x: 0, y: 35 }, radiusMm: 21.5, gripMu: 0.8 },
    { atMm: { x: 0, y: -35 }, radiusMm: 21.5, gripMu: 0.8 },
  ],
  drive: { ...LITE_DRIVE, ...drive },
});

/** An arena with one robot in it, and the actions of the tests. */
export interface Rig {
  readonly world: World;
  readonly robot: Chassis;
  /** Sets both duties, in bytes of 255 as the robot's controller takes them, and lets the time pass. */
  readonly drive: (leftByte: number, rightByte: number, seconds: number) => void;
}

/** Makes an arena of 4 × 4 m (or another size) with a robot. */
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

/** Duty, in bytes of 255, at which the test robot's wheels run at this speed on a straight line, by the drive law alone. */
export function byteForSpeed(speedMmPerS: number, drive: DriveLaw = LITE_DRIVE): number {
  const share = speedMmPerS / drive.v0MmPerS;
  return (255 * (drive.coulomb + drive.viscous * share)) / (1 - share);
}

/** FNV-1a over the 64 bits of numbers: one wrong bit anywhere changes it. */
export function hashOf(numbers: readonly number[]): string {
  const view = new DataView(new ArrayBuffer(8));
  let hash = 0x811c9dc5;
  for (const value of numbers) {
    view.setFloat64(0, value);
    for (let byte = 0; byte < 8; byte++) hash = Math.imul(hash ^ view.getUint8(byte), 0x01000193);
  }
  return (hash >>> 0).toString(16).padStart(8, '0');
}

/** A run with everything in it: walls, loose and fixed blocks, curves, collisions, a cone; its numbers every 20 ms. */
export function eventfulRun(): number[] {
  const { world, robot, drive } = createRig({ xMm: 300, yMm: 300, headingRad: 0.3 }, testChassis(), {
    widthMm: 1200,
    heightMm: 900,
  });
  world.addWall({ fromMm: { x: 800, y: 100 }, toMm: { x: 950, y: 500 }, thicknessMm: 10 });
  const blocks = [0, 1, 2, 3].map((i) =>
    world.addBlock({
      atMm: { x: 450 + 70 * i, y: 330 + 20 * i },
      sizeMm: { x: 50, y: 40 },
      angleRad: i / 3,
      fixed: i === 3,
    }),
  );
  const numbers: number[] = [];
  const cone = { openingRad: 0.5, rangeMm: 2000 };
  for (let i = 0; i < 750; i++) {
    drive(40 + ((i * 7) % 90), i % 200 < 150 ? 60 : -40, 0.02);
    const bodies = [robot, ...blocks].map((body) => body.pose());
    for (const pose of bodies) numbers.push(pose.xMm, pose.yMm, pose.headingRad);
    const { x, y } = robot.toWorld({ x: 60, y: 0 });
    numbers.push(world.distanceCone({ x, y }, robot.pose().headingRad, cone, robot).distanceMm, robot.pathMm());
  }
  return numbers;
}

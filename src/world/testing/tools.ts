import type { Vec } from '#core/geometry';
import type { ForkType, Gripper, GripperType } from '../chassis';
import type { BlockHandle } from '../shapes';
import { STEP_S } from '../step';
import { createRig } from './rig';
import type { Rig } from './rig';

/** A claw ahead of the test robot: curved jaws of two parts each, 44 mm long, whose tips meet when it is closed. */
export const TEST_CLAW: GripperType = {
  hingeMm: { x: 71, y: 15 },
  jawMm: [
    [
      { x: -1, y: -3 },
      { x: 22, y: 9 },
      { x: 20, y: 14 },
      { x: -3, y: 2 },
    ],
    [
      { x: 19.5, y: 9.5 },
      { x: 41, y: -14 },
      { x: 44, y: -12 },
      { x: 22.5, y: 13.5 },
    ],
  ],
  forceN: 2,
};

/** Swing of the claw when it is wide open: 50°. */
export const OPEN_RAD = 0.873;

/** A fork whose plate reaches from 1 to 61 mm ahead of the test robot's front. */
export const TEST_FORK: ForkType = {
  plateMm: [
    { x: 60, y: -25 },
    { x: 120, y: -25 },
    { x: 120, y: 25 },
    { x: 60, y: 25 },
  ],
  clearMm: 4,
};

/** Height of the fork when it is up. */
export const UP_MM = 40;

/** A rig that moves servos. */
export interface ToolRig extends Rig {
  /** A block with its middle there. */
  readonly block: (atMm: Vec, sideMm?: number, angleRad?: number, fixed?: boolean) => BlockHandle;
  /** Swings a gripper from its present angle to another at 5 rad/s, as a servo does, and waits a moment. */
  readonly swing: (gripper: Gripper, toRad: number) => void;
}

/** A robot in the middle of 4 × 4 m that looks along x. */
export function createToolRig(start = { xMm: 2000, yMm: 2000, headingRad: 0 }): ToolRig {
  const rig = createRig(start);
  return {
    ...rig,
    block: (atMm, sideMm = 50, angleRad = 0, fixed = false) =>
      rig.world.addBlock({ atMm, sizeMm: { x: sideMm, y: sideMm }, angleRad, fixed }),
    swing: (gripper, toRad) => {
      let now = gripper.swingRad();
      while (now !== toRad) {
        now += Math.min(Math.max(toRad - now, -5 * STEP_S), 5 * STEP_S);
        gripper.setSwing(now);
        rig.world.step();
      }
      for (let step = 0; step < 25; step++) rig.world.step();
    },
  };
}

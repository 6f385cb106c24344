/** New Robot: its body, as everyone may know it. Frame and units: see ../robot.ts. Where each number comes from: SOURCES.md. */
import { colourOptions } from '../colour-options';
import type { Vec } from '#core/geometry';
import type { ChassisType } from '#world/chassis';
import type { RobotType } from '../robot';
import { wheelPair } from '../wheels';

const TRACK_MM = 80; // distance between the middles of the wheels: chosen
const WHEEL_RADIUS_MM = 20; // chosen
const GRIP_MU = 0.8; // rubber on a smooth floor: chosen

/** A box around body and wheels. Convex, counter-clockwise; a body of another shape takes several parts. */
const OUTLINE: readonly Vec[] = [
  { x: -25, y: -45 },
  { x: 60, y: -45 },
  { x: 60, y: 45 },
  { x: -25, y: 45 },
];

const body: ChassisType = {
  outlineMm: [OUTLINE],
  heightMm: 85, // chosen: to the top of the upright micro:bit
  massG: 150, // chosen: weigh yours
  centreOfMassMm: { x: 10, y: 0 }, // chosen: between axle and castor
  wheels: wheelPair(TRACK_MM, { radiusMm: WHEEL_RADIUS_MM, gripMu: GRIP_MU }),
  castorMm: { x: 50, y: 0 }, // chosen
  // Chosen: a small gear motor. What the constants mean: world/drive-law.ts. How to fit them: CONTRIBUTING.md.
  drive: {
    v0MmPerS: 300,
    coulomb: 0.03,
    viscous: 0.1,
    yawResistance: 0.04,
    stallForceN: 1,
    lagS: 0.03,
  },
};

export const newRobot: RobotType = {
  id: 'new-robot',
  name: 'New Robot',
  place: 99,
  board: 'microbit-v2',
  body,
  modules: ['new_robot'],
  options: [...colourOptions],
  mountMm: null,
};

/**
 * 4tronix bit:bot XL (v1.2): its body. Frame and units: see ../robot.ts. Where each number comes from: SOURCES.md;
 * GMC = gmc-code/PC-Microbit-Extension, 4T = 4tronix/BitBot. The maker publishes no drawing: most of it is estimated.
 */
import type { Vec } from '#core/geometry';
import type { ChassisType } from '#world/chassis';
import { cameraOption } from '../camera-options';
import { colourOptions } from '../colour-options';
import { echoOption } from '../echo';
import { incidenceOption } from '../incidence';
import type { RobotType } from '../robot';
import { wheelPair } from '../wheels';

/** Distance between the middles of the wheels: estimated, that of the bit:bot PRO (half of it 53.8 mm, 4T), rounded. */
const TRACK_MM = 107;
const WHEEL_RADIUS_MM = 32.5; // diameter 65: estimated, the usual wheel of this size of motor
const GRIP_MU = 0.8; // rubber on a smooth floor: chosen, as for the others

/** Outline: 110 mm long and 120 mm wide over the wheels (GMC: 11 × 12 cm); how it divides is chosen. */
const FRONT: readonly Vec[] = [
  { x: 72, y: -24 },
  { x: 72, y: 24 },
  { x: 56, y: 42 },
  { x: 33, y: 46 },
  { x: 33, y: -46 },
  { x: 56, y: -42 },
];
const REAR_WITH_WHEELS: readonly Vec[] = [
  { x: 33, y: -46 },
  { x: 33, y: 46 },
  { x: 32.5, y: 60 },
  { x: -32.5, y: 60 },
  { x: -38, y: 44 },
  { x: -38, y: -44 },
  { x: -32.5, y: -60 },
  { x: 32.5, y: -60 },
];

const body: ChassisType = {
  outlineMm: [FRONT, REAR_WITH_WHEELS],
  heightMm: 55, // with the micro:bit upright: GMC
  massG: 200, // chosen, not weighed: about 150 g kit, 9 g micro:bit, 40 g for three AAA cells
  centreOfMassMm: { x: 8, y: 0 }, // between axle and castor, near the axle: chosen
  wheels: wheelPair(TRACK_MM, { radiusMm: WHEEL_RADIUS_MM, gripMu: GRIP_MU }),
  castorMm: { x: 50, y: 0 }, // chosen: behind the line sensors
  drive: {
    // Estimated, nothing is measured: the PRO's motor (155 rpm at 6 V, maker's page) would turn this wheel at 396 mm/s
    // on 4.5 V; loaded 370. The drivers' slowest speeds are 123 (GMC, 1 of 10) and 200 of 1023 (ETH): both must drive.
    v0MmPerS: 430,
    coulomb: 0.05,
    breakaway: { share: 0.05, until: 0.3 },
    viscous: 0.1,
    yawResistance: 0.05,
    stallForceN: 1.5, // chosen: the same kind of gear motor as those of the Maqueens
    lagS: 0.05, // chosen
  },
};

export const bitbotXl: RobotType = {
  id: 'bitbot-xl',
  name: 'bit:bot XL',
  place: 7,
  board: 'microbit-v2',
  body,
  modules: ['mbbitbot'],
  // Its left() turns to the right, and it has no delay().
  measuring: 'from mbbitbot import *\nfrom mbbitbot import right as left\n\ndelay = sleep',
  driverNames: ['bitbotxl', 'bitbot'], // GMC's module is BitBotXL
  options: [echoOption, incidenceOption, ...colourOptions, cameraOption],
  hearsRemote: false,
  mountMm: null,
};

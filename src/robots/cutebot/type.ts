/**
 * Elecfreaks Smart Cutebot: its body. Frame and units: see ../robot.ts. Where each number comes from: SOURCES.md;
 * BS = microsoft/microbit-robot `botsim`, VT = Vittascience.
 */
import { attachmentOptions } from '#attachments/options';
import type { Vec } from '#core/geometry';
import type { ChassisType } from '#world/chassis';
import { cameraOption } from '../camera-options';
import { colourOptions } from '../colour-options';
import { echoOption } from '../echo';
import { incidenceOption } from '../incidence';
import type { RobotType } from '../robot';
import { wheelPair } from '../wheels';
import measuring from './measuring.py?raw';

/** Ports of the two servos. */
export const SERVO_PORTS = ['S1', 'S2'] as const;

const TRACK_MM = 76; // distance between the middles of the wheels: BS
const WHEEL_RADIUS_MM = 18; // diameter 36: BS; VT says 34
const GRIP_MU = 0.8; // rubber on a smooth floor: chosen, as for the Maqueens

/** The round front ends 0.5 mm ahead of the wheels. */
const FRONT_FROM_X = 18.5;

/** Outline: a circle of 86 mm whose middle is 15 mm ahead of the axle, cut out around the wheels, which are 13 mm wide (BS). */
const FRONT: readonly Vec[] = [
  { x: FRONT_FROM_X, y: -42.8 },
  { x: 31.4, y: -39.7 },
  { x: 45.4, y: -30.4 },
  { x: 54.7, y: -16.4 },
  { x: 58, y: 0 },
  { x: 54.7, y: 16.4 },
  { x: 45.4, y: 30.4 },
  { x: 31.4, y: 39.7 },
  { x: FRONT_FROM_X, y: 42.8 },
];
const REAR_WITH_WHEELS: readonly Vec[] = [
  { x: FRONT_FROM_X, y: -31 },
  { x: FRONT_FROM_X, y: 31 },
  { x: 18, y: 44.5 },
  { x: -18, y: 44.5 },
  { x: -24.5, y: 17.5 },
  { x: -28, y: 0 },
  { x: -24.5, y: -17.5 },
  { x: -18, y: -44.5 },
  { x: 18, y: -44.5 },
];

const body: ChassisType = {
  outlineMm: [FRONT, REAR_WITH_WHEELS],
  heightMm: 85, // chosen, to the top of the upright micro:bit
  massG: 150, // chosen, not weighed: about 95 g kit, 9 g micro:bit, 46 g for three AAA cells with their holder
  centreOfMassMm: { x: 8, y: 0 }, // between axle and castor, near the axle: chosen, as for the Lite
  wheels: wheelPair(TRACK_MM, { radiusMm: WHEEL_RADIUS_MM, gripMu: GRIP_MU }),
  castorMm: { x: 34, y: 0 }, // chosen: behind the line sensors
  // Estimated: nobody has published a measurement. Which hints it is made to meet: SOURCES.md, “How it drives”
  drive: {
    v0MmPerS: 600,
    coulomb: 0.088,
    breakaway: { share: 0.062, until: 0.25 },
    viscous: 0.216,
    yawResistance: 0, // not known
    stallForceN: 0.53, // the Lite's motor, geared for 300 turns a minute (VT) instead of 133, on a smaller wheel: computed
    lagS: 0.03, // chosen, as for the Lite
  },
};

export const cutebot: RobotType = {
  id: 'cutebot',
  name: 'Cutebot',
  place: 8,
  board: 'microbit-v2',
  body,
  modules: ['cutebot', 'Cutebot'],
  sameModules: { Cutebot: 'cutebot' }, // the name of Elecfreaks' own file
  measuring,
  options: [...attachmentOptions(SERVO_PORTS), echoOption, incidenceOption, ...colourOptions, cameraOption],
  mountMm: { x: 58, y: 0 },
};

/**
 * DFRobot Maqueen Plus V1: its body. Frame and units: see ../robot.ts. Where each number comes from: SOURCES.md;
 * NOE = NoeSchaller/TS_Maqueen.
 */
import { attachmentOptions } from '#attachments/options';
import type { Vec } from '#core/geometry';
import type { ChassisType } from '#world/chassis';
import { cameraOption } from '../camera-options';
import { colourOptions } from '../colour-options';
import { incidenceOption } from '../incidence';
import type { RobotType } from '../robot';
import { wheelPair } from '../wheels';

/** Ports of the three servos. */
export const SERVO_PORTS = ['S1', 'S2', 'S3'] as const;

const TRACK_MM = 90; // distance between the middles of the wheels: NOE
const WHEEL_RADIUS_MM = 21.5; // diameter 43: NOE; informatiquecsud/mbrobot rolls 135 mm per turn
const GRIP_MU = 0.8; // rubber on a smooth floor: chosen, as for the Lite

/** Outline: NOE's polygon with the axle 27 mm behind its middle; the wheels are 9 mm wide (NOE). */
const FRONT: readonly Vec[] = [
  { x: 78.5, y: -23 },
  { x: 78.5, y: 23 },
  { x: 43.5, y: 50 },
  { x: 23.5, y: 50 },
  { x: 23.5, y: -50 },
  { x: 43.5, y: -50 },
];
const REAR_WITH_WHEELS: readonly Vec[] = [
  { x: 23.5, y: -38 },
  { x: 23.5, y: 38 },
  { x: 21.5, y: 49.5 },
  { x: -21.5, y: 49.5 },
  { x: -24.5, y: 38 },
  { x: -24.5, y: -38 },
  { x: -21.5, y: -49.5 },
  { x: 21.5, y: -49.5 },
];

const body: ChassisType = {
  outlineMm: [FRONT, REAR_WITH_WHEELS],
  heightMm: 85, // chosen, to the top of the upright micro:bit
  massG: 230, // chosen, not weighed: metal frame and motors, 9 g micro:bit, battery
  centreOfMassMm: { x: 12, y: 0 }, // between axle and castor, near the axle: chosen
  wheels: wheelPair(TRACK_MM, { radiusMm: WHEEL_RADIUS_MM, gripMu: GRIP_MU }),
  castorMm: { x: 46, y: 0 }, // chosen: behind the line sensors
  drive: {
    // Fitted: scripts/fit-motor-law.mjs, residuals in docs/hardware/maqueen-plus-v1-motor-law.md
    v0MmPerS: 391,
    coulomb: 0,
    breakaway: { share: 0.0163, until: 0.1258 },
    viscous: 0.1929,
    yawResistance: 0,
    stallForceN: 1.5, // chosen: the same kind of gear motor as the Lite's, on 3.7 V through a regulator
    lagS: 0.02, // chosen, as for the V2
  },
};

export const maqueenPlusV1: RobotType = {
  id: 'maqueen-plus-v1',
  name: 'Maqueen Plus V1',
  place: 5,
  board: 'microbit-v2',
  body,
  modules: ['mbrobot_plus'],
  driverNames: ['maqueenplusv1', 'maqueenplus', 'Maqueen_Plus'], // the last two: lawther, Koraze
  options: [...attachmentOptions(SERVO_PORTS), incidenceOption, ...colourOptions, cameraOption],
  mountMm: { x: 78.5, y: 0 },
};

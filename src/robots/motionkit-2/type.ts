/**
 * Calliope MotionKit 2: its body. Frame and units: see ../robot.ts. Nothing about it is published. It looks as if it stood
 * on the Maqueen Lite's frame, so all measures are estimates: those of that robot (NoeSchaller/TS_Maqueen,
 * Tiger-Jython/Robotics-Libraries). SOURCES.md lists them, docs/hardware/motionkit-2.md says how to settle them.
 */
import { attachmentOptions } from '#attachments/options';
import type { Vec } from '#core/geometry';
import { optionOf } from '#core/option';
import type { ChassisType } from '#world/chassis';
import { cameraOption } from '../camera-options';
import { colourOptions } from '../colour-options';
import { incidenceOption } from '../incidence';
import type { RobotType } from '../robot';
import { wheelPair } from '../wheels';
import words from './words';

/** Ports of the two servos. */
export const SERVO_PORTS = ['S1', 'S2'] as const;

const TRACK_MM = 70; // estimated: the Lite's
const WHEEL_RADIUS_MM = 21.5; // estimated: the Lite's
const GRIP_MU = 0.8; // rubber on a smooth floor: chosen; only pushing and stalling depend on it

/** Estimated: the Lite's outline, 80 × 80 mm. The wheels are 9 mm wide. */
const FRONT: readonly Vec[] = [
  { x: 58, y: -21 },
  { x: 58, y: 21 },
  { x: 43, y: 40 },
  { x: 26, y: 40 },
  { x: 26, y: -40 },
  { x: 43, y: -40 },
];
const REAR_WITH_WHEELS: readonly Vec[] = [
  { x: 26, y: -29 },
  { x: 26, y: 29 },
  { x: 21.5, y: 39.5 },
  { x: -21.5, y: 39.5 },
  { x: -22, y: 29 },
  { x: -22, y: -29 },
  { x: -21.5, y: -39.5 },
  { x: 21.5, y: -39.5 },
];

const body: ChassisType = {
  outlineMm: [FRONT, REAR_WITH_WHEELS],
  heightMm: 65, // chosen: to the top of the ultrasonic sensor, as the Calliope mini lies flat
  massG: 150, // chosen, not weighed: the Lite's 121 g of kit and cells, 27 g Calliope mini 3
  centreOfMassMm: { x: 8, y: 0 }, // between axle and castor, near the axle: chosen
  wheels: wheelPair(TRACK_MM, { radiusMm: WHEEL_RADIUS_MM, gripMu: GRIP_MU }),
  castorMm: { x: 46, y: 0 }, // chosen: between line sensors and front edge
  // Estimated: the law fitted for the Lite (docs/hardware/maqueen-lite-motor-law.md). It moves at byte 15, the least that the
  // school library sends, and drives 16 cm/s at its usual 30.
  drive: {
    v0MmPerS: 423,
    coulomb: 0.0196,
    breakaway: { share: 0.0079, until: 0.2966 },
    viscous: 0.1467,
    yawResistance: 0.1123,
    stallForceN: 1,
    lagS: 0.03,
  },
};

export const motionkit2: RobotType = {
  id: 'motionkit-2',
  name: 'MotionKit 2',
  place: 6,
  board: 'calliope-mini-3',
  body,
  modules: ['callimk'],
  driverNames: ['motionkit', 'motionkitv2', 'motionkit2', 'mklib'],
  options: [
    ...attachmentOptions(SERVO_PORTS),
    optionOf('sides', words.options.sides, ['maker', 'lights-swapped', 'all-swapped'], { isExpert: true }),
    optionOf('echo', words.options.echo, ['minus-one', 'zero'], { isExpert: true }),
    incidenceOption,
    ...colourOptions,
    cameraOption,
  ],
  mountMm: { x: 58, y: 0 },
};

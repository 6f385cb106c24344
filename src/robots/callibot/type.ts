/**
 * Knotech Calli:bot 2E: its body. Frame and units: see ../robot.ts. Where each number comes from: SOURCES.md;
 * CN = calliope-net/callibot2. No drawing of the robot is public, so most measures are chosen after photographs.
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

const TRACK_MM = 80; // CN sensoren.ts
/** Diameter 45.5: CN sensoren.ts. */
const WHEEL_RADIUS_MM = 22.75;
const GRIP_MU = 0.8; // rubber on a smooth floor: chosen; only pushing and stalling depend on it

/** Chosen: a nose for the sensors, and a narrower rear between the wheels, which are 9.6 mm wide. */
const FRONT: readonly Vec[] = [
  { x: 60, y: -25 },
  { x: 60, y: 25 },
  { x: 43, y: 43 },
  { x: 27, y: 43 },
  { x: 27, y: -43 },
  { x: 43, y: -43 },
];
const REAR_WITH_WHEELS: readonly Vec[] = [
  { x: 27, y: -32 },
  { x: 27, y: 32 },
  { x: 22.75, y: 44.5 },
  { x: -22.75, y: 44.5 },
  { x: -27, y: 32 },
  { x: -27, y: -32 },
  { x: -22.75, y: -44.5 },
  { x: 22.75, y: -44.5 },
];

/**
 * The left half of the bumper bar; the right one is its mirror image. Chosen: with it the robot is 108 mm long and 100
 * mm wide. It is pointed by 3°, so that both halves touch a wall that the robot meets nearly straight; at a slant, one
 * of them does.
 */
export const BUMPER_LEFT: readonly Vec[] = [
  { x: 66, y: 0 },
  { x: 81, y: 0 },
  { x: 80, y: 18 },
  { x: 78, y: 33 },
  { x: 74.5, y: 44 },
  { x: 69, y: 50 },
  { x: 62, y: 48 },
];
export const BUMPER_RIGHT: readonly Vec[] = BUMPER_LEFT.map(({ x, y }) => ({ x, y: -y })).reverse();

const body: ChassisType = {
  outlineMm: [FRONT, REAR_WITH_WHEELS],
  heightMm: 90, // chosen, with the Calliope mini on its holder
  massG: 250, // chosen, not weighed: about 100 g kit, 27 g Calliope mini 3, 120 g for the batteries with their holder
  centreOfMassMm: { x: 8, y: 0 }, // between axle and castor, near the axle: chosen
  wheels: wheelPair(TRACK_MM, { radiusMm: WHEEL_RADIUS_MM, gripMu: GRIP_MU }),
  castorMm: { x: 50, y: 0 }, // chosen: below the front edge
  drive: {
    // Fitted: scripts/fit-motor-law.mjs, residuals in docs/hardware/callibot-motor-law.md
    v0MmPerS: 484,
    coulomb: 0,
    breakaway: { share: 0.0314, until: 0.1418 },
    viscous: 0.3954,
    yawResistance: 0,
    stallForceN: 1.5, // chosen: motors like the Lite's, stronger in proportion to its weight
    lagS: 0.03, // chosen, as for the Maqueen Lite: 0.06 s at the usual speed of 50
  },
};

export const callibot: RobotType = {
  id: 'callibot',
  name: 'Calli:bot',
  place: 4,
  board: 'calliope-mini-3',
  body,
  modules: ['callibot', 'callibotmot', 'cbalarm'],
  driverNames: ['callibot2', 'callibot2e', 'cblib'],
  options: [
    optionOf('model', words.options.model, ['2E', '2', '1']),
    optionOf('bumper', words.options.bumper, ['when-read', 'always']),
    optionOf('echo', words.options.echo, ['far', 'zero'], { isExpert: true }),
    incidenceOption,
    ...colourOptions,
    cameraOption,
    ...attachmentOptions(SERVO_PORTS),
  ],
  hearsRemote: false,
  mountMm: { x: 60, y: 0 },
};

/**
 * DFRobot Maqueen Plus V2: its body. Frame and units: see ../robot.ts. Where each number comes from: SOURCES.md;
 * NOE = NoeSchaller/TS_Maqueen (its Maqueen Plus is the V1, of the same shape), GBSL = GBSL-Informatik/maqueen-plus-v2-mpy.
 */
import { attachmentOptions } from '#attachments/options';
import type { Option } from '#core/option';
import type { Vec } from '#core/geometry';
import type { ChassisType } from '#world/chassis';
import { echoOption } from '../echo';
import { incidenceOption } from '../incidence';
import type { RobotType } from '../robot';
import words from './words';

/** Ports of the three servos, named after their pins. */
export const SERVO_PORTS = ['P0', 'P1', 'P2'] as const;

/** Distance between the middles of the wheels: Tiger-Jython/Aplu-Libraries and jhautbois/maqueen-plus-v3 (82). */
const TRACK_MM = 82;
const WHEEL_RADIUS_MM = 21.5; // diameter 43: MINTspark/pxt-mintspark-drivemaqueenplusv2
const GRIP_MU = 0.8; // rubber on a smooth floor: chosen, as for the Lite

/** Outline: NOE's polygon with the axle 27 mm behind its middle, narrowed between the wheels, which are 9 mm wide (NOE). */
const FRONT: readonly Vec[] = [
  { x: 78.5, y: -23 },
  { x: 78.5, y: 23 },
  { x: 43.5, y: 50 },
  { x: 24, y: 50 },
  { x: 24, y: -50 },
  { x: 43.5, y: -50 },
];
const REAR_WITH_WHEELS: readonly Vec[] = [
  { x: 24, y: -35 },
  { x: 24, y: 35 },
  { x: 21.5, y: 45.5 },
  { x: -21.5, y: 45.5 },
  { x: -24.5, y: 35 },
  { x: -24.5, y: -35 },
  { x: -21.5, y: -45.5 },
  { x: 21.5, y: -45.5 },
];

const body: ChassisType = {
  outlineMm: [FRONT, REAR_WITH_WHEELS],
  heightMm: 85, // chosen, to the top of the upright micro:bit
  massG: 230, // chosen, not weighed: metal frame and motors, 9 g micro:bit, 46 g cell
  centreOfMassMm: { x: 12, y: 0 }, // between axle and castor, near the axle, as the cell lies behind it: chosen
  wheels: [
    { atMm: { x: 0, y: TRACK_MM / 2 }, radiusMm: WHEEL_RADIUS_MM, gripMu: GRIP_MU },
    { atMm: { x: 0, y: -TRACK_MM / 2 }, radiusMm: WHEEL_RADIUS_MM, gripMu: GRIP_MU },
  ],
  castorMm: { x: 46, y: 0 }, // chosen: behind the middle line sensor
  drive: {
    // Fitted: scripts/fit-motor-law.mjs, residuals in docs/hardware/maqueen-plus-v2-motor-law.md
    v0MmPerS: 247,
    coulomb: 0,
    breakaway: { share: 0.0364, until: 0.3277 },
    viscous: 0.1547,
    yawResistance: 0.1294,
    stallForceN: 1.5, // chosen: the same kind of gear motor as the Lite's, on 3.7 V through a regulator
    // chosen: 0.1 s at the usual speed of 50; with the Lite's 0.03 the first circles begin as spirals, because a wheel
    // at byte 15 then takes a second to reach its speed
    lagS: 0.02,
  },
};

const options: readonly Option[] = [
  ...attachmentOptions(SERVO_PORTS),
  {
    id: 'version',
    title: words.version.title,
    about: words.version.about,
    isExpert: true,
    choices: [
      { id: '2.1', title: words.version.choices['2.1'] },
      { id: '2.0', title: words.version.choices['2.0'] },
    ],
  },
  {
    id: 'analogOrder',
    title: words.analogOrder.title,
    about: words.analogOrder.about,
    isExpert: true,
    choices: [
      { id: 'R2-first', title: words.analogOrder.choices['R2-first'] },
      { id: 'L2-first', title: words.analogOrder.choices['L2-first'] },
    ],
  },
  {
    id: 'analogPolarity',
    title: words.analogPolarity.title,
    about: words.analogPolarity.about,
    isExpert: true,
    choices: [
      { id: 'light-high', title: words.analogPolarity.choices['light-high'] },
      { id: 'light-low', title: words.analogPolarity.choices['light-low'] },
    ],
  },
  echoOption,
  incidenceOption,
];

export const maqueenPlusV2: RobotType = {
  id: 'maqueen-plus-v2',
  name: 'Maqueen Plus V2',
  place: 2,
  board: 'microbit-v2',
  body,
  modules: ['mbrobot_plusV2'],
  driverNames: ['maqueenplusv2', 'maqueen_plus'], // the latter: almasy
  options,
  mountMm: { x: 78.5, y: 0 },
};

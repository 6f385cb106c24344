/**
 * DFRobot Maqueen Plus V3: its body. Frame and units: see ../robot.ts. Where each number comes from: SOURCES.md; what no
 * source says, and how to find it out on a real one: docs/hardware/maqueen-plus-v3.md.
 */
import { attachmentOptions } from '#attachments/options';
import type { OptionValues, Option } from '#core/option';
import type { Vec } from '#core/geometry';
import { inEvery } from '#core/words';
import type { ChassisType } from '#world/chassis';
import { echoOption } from '../echo';
import { incidenceOption } from '../incidence';
import type { RobotType } from '../robot';
import words from './words';

/** Ports of the three servos, named after their pins: S1, S2 and S3 on the robot. */
export const SERVO_PORTS = ['P0', 'P1', 'P2'] as const;

/** Distance between the middles of the wheels: jhautbois/maqueen-plus-v3-micropython, and the V2's. */
export const TRACK_MM = 82;
const WHEEL_RADIUS_MM = 21.5; // diameter 43: jhautbois/maqueen-plus-v3-micropython
const GRIP_MU = 0.8; // rubber on a smooth floor: chosen, as for the Lite

/** Outline: the V2's, whose frame it has. */
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

/** Rated speeds of the motors that fit its sockets, in turns per minute: DFRobot maqueenPlusV2.ts, `MotorType`. */
const MOTORS = [133, 266] as const;

const body: ChassisType = {
  outlineMm: [FRONT, REAR_WITH_WHEELS],
  heightMm: 118, // chosen, to the top of the lidar, whose lens is at 104
  massG: 240, // chosen: a V2 weighs 208 g (microsoft/microbit-robot), and there are lidar and bracket
  centreOfMassMm: { x: 12, y: 0 }, // as the V2's: chosen
  wheels: [
    { atMm: { x: 0, y: TRACK_MM / 2 }, radiusMm: WHEEL_RADIUS_MM, gripMu: GRIP_MU },
    { atMm: { x: 0, y: -TRACK_MM / 2 }, radiusMm: WHEEL_RADIUS_MM, gripMu: GRIP_MU },
  ],
  castorMm: { x: 46, y: 0 }, // as the V2's: chosen
  drive: {
    // Through the three measured speeds, by hand: 28.5 mm/s at byte 35 (sjh5637/myMaqueenPlusV3_extension), 130 at 100
    // (jhautbois), 290 at 255 (133 turns a minute without load).
    v0MmPerS: 800,
    coulomb: 0.0773,
    viscous: 1.545,
    breakaway: { share: 0.0325, until: 0.03 }, // starts at byte 28; from byte 35 on it has vanished: below about 30
    // franc0r/francor-maqueen-plus-microbit saw no motion
    yawResistance: 4.4, // the scrub of the V2's tyres and castor, for this v0: 0.1294 · (800 / 247)³
    stallForceN: 1.5, // chosen: the V2's
    lagS: 0.115, // 0.15 s at byte 100: franc0r's quarter turn takes 650 ms, and 495 ms without a start
  },
};

/** The same body with the motors that the options name. */
function bodyWith({ motors }: OptionValues): ChassisType {
  const turns = MOTORS.find((rpm) => String(rpm) === motors) ?? MOTORS[0];
  return { ...body, drive: { ...body.drive, v0MmPerS: (body.drive.v0MmPerS * turns) / MOTORS[0] } };
}

const LIDAR_ADDRESSES = ['0x33', '0x32', '0x31', '0x30'] as const; // as delivered first: DFRobot SEN0628

const WITH_LIDAR = { option: 'lidar', choices: ['8x8', '4x4'] } as const;
const WITH_ULTRASONIC = { option: 'ultrasonic', choices: ['yes'] } as const;

const options: readonly Option[] = [
  ...attachmentOptions(SERVO_PORTS),
  {
    id: 'lidar',
    title: words.lidar.title,
    choices: [
      { id: '8x8', title: words.lidar.choices['8x8'] },
      { id: '4x4', title: words.lidar.choices['4x4'] },
      { id: 'none', title: words.lidar.choices.none },
    ],
  },
  {
    id: 'ultrasonic',
    title: words.ultrasonic.title,
    about: words.ultrasonic.about,
    choices: [
      { id: 'no', title: words.ultrasonic.choices.no },
      { id: 'yes', title: words.ultrasonic.choices.yes },
    ],
  },
  {
    id: 'motors',
    title: words.motors.title,
    about: words.motors.about,
    choices: [
      { id: '133', title: words.motors.choices['133'] },
      { id: '266', title: words.motors.choices['266'] },
    ],
  },
  {
    id: 'lidarAddress',
    title: words.lidarAddress.title,
    about: words.lidarAddress.about,
    isExpert: true,
    onlyWith: WITH_LIDAR,
    choices: LIDAR_ADDRESSES.map((id) => ({ id, title: inEvery(() => id) })),
  },
  {
    id: 'lidarEmpty',
    title: words.lidarEmpty.title,
    about: words.lidarEmpty.about,
    isExpert: true,
    onlyWith: WITH_LIDAR,
    choices: [
      { id: '4000', title: words.lidarEmpty.choices['4000'] },
      { id: '0', title: words.lidarEmpty.choices['0'] },
    ],
  },
  {
    id: 'lidarOrder',
    title: words.lidarOrder.title,
    about: words.lidarOrder.about,
    isExpert: true,
    onlyWith: WITH_LIDAR,
    choices: [
      { id: 'maker', title: words.lidarOrder.choices.maker },
      { id: 'transposed', title: words.lidarOrder.choices.transposed },
    ],
  },
  { ...echoOption, onlyWith: WITH_ULTRASONIC },
  { ...incidenceOption, onlyWith: WITH_ULTRASONIC },
];

export const maqueenPlusV3: RobotType = {
  id: 'maqueen-plus-v3',
  name: 'Maqueen Plus V3',
  place: 3,
  board: 'microbit-v2',
  body,
  bodyWith,
  modules: ['mbrobot_plusV3'],
  driverNames: ['maqueenplusv3'], // Vittascience; jhautbois
  options,
  mountMm: { x: 78.5, y: 0 },
};

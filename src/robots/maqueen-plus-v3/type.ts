/**
 * DFRobot Maqueen Plus V3: its body. Frame and units: see ../robot.ts. Where each number comes from: SOURCES.md; what no
 * source says, and how to find it out on a real one: docs/hardware/maqueen-plus-v3.md.
 */
import { attachmentOptions } from '#attachments/options';
import { optionOf, type OptionValues, type Option } from '#core/option';
import { inEvery } from '#core/words';
import type { ChassisType } from '#world/chassis';
import { cameraOption } from '../camera-options';
import { colourOptions } from '../colour-options';
import { echoOption } from '../echo';
import { incidenceOption } from '../incidence';
import { PLUS_MOUNT_MM, plusFrame } from '../maqueen-plus-frame';
import type { RobotType } from '../robot';
import words from './words';

/** Ports of the three servos, named after their pins: S1, S2 and S3 on the robot. */
export const SERVO_PORTS = ['P0', 'P1', 'P2'] as const;

/** Rated speeds of the motors that fit its sockets, in turns per minute: DFRobot maqueenPlusV2.ts, `MotorType`. */
const MOTORS = [133, 266] as const;

const body: ChassisType = {
  ...plusFrame,
  heightMm: 118, // chosen, to the top of the lidar, whose lens is at 104
  massG: 240, // chosen: a V2 weighs 208 g (microsoft/microbit-robot), and there are lidar and bracket
  drive: {
    // Through the three measured speeds, by hand: 28.5 mm/s at byte 35 (sjh5637/myMaqueenPlusV3_extension), 130 at 100
    // (jhautbois), 290 at 255 (133 turns a minute without load).
    v0MmPerS: 800,
    coulomb: 0.0773,
    viscous: 1.545,
    // Starts at byte 28, as franc0r/francor-maqueen-plus-microbit saw no motion below about 30; gone from byte 35 on.
    breakaway: { share: 0.0325, until: 0.03 },
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
  optionOf('lidar', words.lidar, ['8x8', '4x4', 'none']),
  optionOf('ultrasonic', words.ultrasonic, ['no', 'yes']),
  optionOf('motors', words.motors, ['133', '266']),
  {
    id: 'lidarAddress',
    title: words.lidarAddress.title,
    about: words.lidarAddress.about,
    isExpert: true,
    onlyWith: WITH_LIDAR,
    choices: LIDAR_ADDRESSES.map((id) => ({ id, title: inEvery(() => id) })),
  },
  optionOf('lidarEmpty', words.lidarEmpty, ['4000', '0'], { isExpert: true, onlyWith: WITH_LIDAR }),
  optionOf('lidarOrder', words.lidarOrder, ['maker', 'transposed'], { isExpert: true, onlyWith: WITH_LIDAR }),
  { ...echoOption, onlyWith: WITH_ULTRASONIC },
  { ...incidenceOption, onlyWith: WITH_ULTRASONIC },
  ...colourOptions,
  cameraOption,
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
  mountMm: PLUS_MOUNT_MM,
};

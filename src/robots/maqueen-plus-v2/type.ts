/**
 * DFRobot Maqueen Plus V2: its body. Frame and units: see ../robot.ts. Where each number comes from: SOURCES.md.
 */
import { attachmentOptions } from '#attachments/options';
import { optionOf, type Option } from '#core/option';
import type { ChassisType } from '#world/chassis';
import { cameraOption } from '../camera-options';
import { colourOptions } from '../colour-options';
import { echoOption } from '../echo';
import { incidenceOption } from '../incidence';
import { PLUS_MOUNT_MM, plusFrame } from '../maqueen-plus-frame';
import type { RobotType } from '../robot';
import words from './words';

/** Ports of the three servos, named after their pins. */
export const SERVO_PORTS = ['P0', 'P1', 'P2'] as const;

const body: ChassisType = {
  ...plusFrame,
  heightMm: 85, // chosen, to the top of the upright micro:bit
  massG: 230, // chosen, not weighed: metal frame and motors, 9 g micro:bit, 46 g cell
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
  optionOf('version', words.version, ['2.1', '2.0'], { isExpert: true }),
  optionOf('analogOrder', words.analogOrder, ['R2-first', 'L2-first'], { isExpert: true }),
  optionOf('analogPolarity', words.analogPolarity, ['light-high', 'light-low'], { isExpert: true }),
  echoOption,
  incidenceOption,
  ...colourOptions,
  cameraOption,
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
  mountMm: PLUS_MOUNT_MM,
};

/**
 * The Maqueen Plus V2's own controller: a register machine at I2C address 0x10 (see #devices/i2c-registers).
 *
 *      register     access  meaning
 *      0x00         RW      left motor direction, 0 forward, 1 backward
 *      0x01         RW      left motor speed, 0 … 255, takes effect at once
 *      0x02         RW      right motor direction
 *      0x03         RW      right motor speed
 *      0x0B         RW      left red light, 0 off, otherwise on
 *      0x0C         RW      right red light
 *      0x1D         R       line sensors: bit 0 = R2, 1 = R1, 2 = M, 3 = L1, 4 = L2; 1 on black, 0 on light ground
 *      0x1E … 0x27  R       brightness of R2, R1, M, L1, L2, two bytes each, low byte first, at most 255;
 *                           on some robots of L2, L1, M, R1, R2
 *      0x32         R       length of the version text
 *      0x33 …       R       version text, ASCII
 *      others               writes are ignored, reads give 0; also the servo registers of the V1 (0x14 … 0x16) and
 *                           the reset register of the V3 (0x49)
 *
 * Sources: DFRobot/pxt-DFRobot_MaqueenPlus_v20 `maqueenPlusV2.ts`, Tiger-Jython/Robotics-Libraries `mbrobot_plusV2.py`,
 * almasy/micropython-maqueen-plus (motor registers read back). On the order of the brightness values see SOURCES.md.
 */
import type { I2cTarget } from '#board/wires/i2c-bus';
import { motorsTouched, type Side } from '#devices/dc-motor';
import {
  bitsOf,
  createRegisterMachine,
  liveRegisters,
  memoryRegisters,
  textRegisters,
  wordRegisters,
} from '#devices/i2c-registers';
import { LINE_NAMES, type LineName } from '../maqueen-plus-frame';

export const CONTROLLER_ADDRESS = 0x10; // DFRobot maqueenPlusV2.ts: I2CADDR

const MOTORS = 0x00;
const LEDS = 0x0b;
const LINE_BITS = 0x1d;
const LINE_VALUES = 0x1e;
const VERSION = 0x32;

/** Direction and speed byte of each motor. */
export type MotorBytes = Readonly<Record<Side, readonly [direction: number, speed: number]>>;

const SIDES: readonly Side[] = ['left', 'right'];

/** The calls with which the controller drives its parts and reads its sensors. */
export interface ControllerParts {
  /**
   * Called after each write transfer that touched a motor register, with the bytes as the program set them; `sides` are
   * the motors that it touched.
   */
  motors(bytes: MotorBytes, sides: readonly Side[]): void;
  /** Called after each write transfer that touched a light; `sides` are those that it touched. */
  leds(left: 0 | 1, right: 0 | 1, sides: readonly Side[]): void;
  isBright(sensor: LineName): boolean;
  /** Brightness, 0 … 255. */
  brightness(sensor: LineName): number;
}

/** The differences between boards of the same kind. */
export interface ControllerOptions {
  /** End of the version text. */
  readonly version: '2.0' | '2.1';
  /** The sensor whose brightness is at 0x1E. */
  readonly analogOrder: 'R2-first' | 'L2-first';
}

/** The version text: product, language, version (GBSL-Informatik/maqueen-plus-v2-mpy: `MBT0021-EN-2.1`). */
export const versionText = (version: ControllerOptions['version']): string => `MBT0021-EN-${version}`;

/** Makes the controller; motors and lights are off. */
export function createController(parts: ControllerParts, { version, analogOrder }: ControllerOptions): I2cTarget {
  const order: readonly LineName[] = analogOrder === 'R2-first' ? LINE_NAMES : [...LINE_NAMES].reverse();
  return createRegisterMachine([
    memoryRegisters(MOTORS, 4, ([dirL = 0, speedL = 0, dirR = 0, speedR = 0], touched) =>
      parts.motors({ left: [dirL, speedL], right: [dirR, speedR] }, motorsTouched(touched)),
    ),
    memoryRegisters(LEDS, 2, ([left, right], { first, last }) =>
      parts.leds(left ? 1 : 0, right ? 1 : 0, SIDES.slice(first, last + 1)),
    ),
    liveRegisters(LINE_BITS, 1, () => bitsOf(LINE_NAMES, (name) => !parts.isBright(name))),
    wordRegisters(LINE_VALUES, LINE_NAMES.length, 'low-first', (word) => {
      const sensor = order[word];
      return sensor === undefined ? 0 : parts.brightness(sensor);
    }),
    textRegisters(VERSION, versionText(version)),
  ]);
}

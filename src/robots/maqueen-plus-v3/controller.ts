/**
 * The Maqueen Plus V3's own controller: a register machine at I2C address 0x10 (see #devices/i2c-registers). Its registers
 * are numbered in decimals, as in all its drivers:
 *
 *      register  access  meaning
 *      0         RW      left motor direction, 0 forward, 1 backward
 *      1         RW      left motor speed, 0 … 255, takes effect at once
 *      2, 3      RW      right motor
 *      11, 12    RW      left, right lamp: 1 red, 2 green, 3 yellow, 4 blue, 5 pink, 6 cyan, 7 white, others off
 *      29        R       line sensors: bit 0 = R2, 1 = R1, 2 = M, 3 = L1, 4 = L2; 1 on black, 0 on light ground
 *      30 … 39   R       brightness of R2, R1, M, L1, L2, two bytes each, low byte first, 0 … 4095
 *
 * Sources: DFRobot/pxt-DFRobot_MaqueenPlus_v20 `maqueenPlusV2.ts` (V2 and V3), Tiger-Jython/Robotics-Libraries
 * `mbrobot_plusV3.py`.
 */
import type { I2cTarget } from '#board/wires/i2c-bus';
import type { Rgb } from '#core/rgb';
import { motorsTouched, signedDuty, type Side } from '#devices/dc-motor';
import { createRegisterMachine, liveRegisters, memoryRegisters, type Touched } from '#devices/i2c-registers';
import { lampColor } from '../lamp-colors';

export const CONTROLLER_ADDRESS = 0x10; // DFRobot maqueenPlusV2.ts: I2CADDR

const MOTORS = 0;
const LAMPS = 11;
const LINE_BITS = 29;
const LINE_VALUES = 30;

/** The line sensors from right to left: the order of their bits and values. */
export const LINE_NAMES = ['R2', 'R1', 'M', 'L1', 'L2'] as const;

/** A line sensor's name, as printed on the robot. */
export type LineName = (typeof LINE_NAMES)[number];

/** The calls with which the controller drives its parts and reads its sensors. */
export interface ControllerParts {
  /** Called after each write transfer that touched a motor: duties −1 … 1 from the bytes; `sides` were touched. */
  motors(left: number, right: number, sides: readonly Side[]): void;
  /** Called after each write transfer that touched a lamp, one or both: 0 left, 1 right. */
  lamps(left: Rgb, right: Rgb, touched: Touched): void;
  isBright(sensor: LineName): boolean;
  /** Brightness, 0 … 4095. */
  brightness(sensor: LineName): number;
}

/** Makes the controller; motors and lamps are off. */
export function createController(parts: ControllerParts): I2cTarget {
  const lineBits = (): number =>
    LINE_NAMES.reduce((bits, name, bit) => (parts.isBright(name) ? bits : bits | (1 << bit)), 0);
  return createRegisterMachine([
    memoryRegisters(MOTORS, 4, ([dirL = 0, speedL = 0, dirR = 0, speedR = 0], touched) =>
      parts.motors(signedDuty(dirL, speedL), signedDuty(dirR, speedR), motorsTouched(touched)),
    ),
    memoryRegisters(LAMPS, 2, ([left = 0, right = 0], touched) =>
      parts.lamps(lampColor(left), lampColor(right), touched),
    ),
    liveRegisters(LINE_BITS, 1, lineBits),
    liveRegisters(LINE_VALUES, 2 * LINE_NAMES.length, (offset) => {
      const name = LINE_NAMES[offset >> 1];
      const value = name === undefined ? 0 : parts.brightness(name);
      return (offset % 2 === 0 ? value : value >> 8) & 0xff;
    }),
  ]);
}

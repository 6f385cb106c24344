/**
 * The New Robot's own controller: a register machine at I2C address 0x10 (see #devices/i2c-registers).
 *
 *      register  access  meaning
 *      0x00      RW      left motor direction, 0 forward, 1 backward
 *      0x01      RW      left motor speed, 0 … 255, takes effect at once
 *      0x02      RW      right motor direction
 *      0x03      RW      right motor speed
 *      others            writes are ignored, reads give 0
 *
 * Source: chosen. Replace it by what your robot's data sheet or its maker's driver says, and name that here.
 */
import type { I2cTarget } from '#board/wires/i2c-bus';
import { createRegisterMachine, memoryRegisters, type Touched } from '#devices/i2c-registers';

export const CONTROLLER_ADDRESS = 0x10; // chosen

const MOTORS = 0x00;

/** Bytes of both motors as the program set them. */
export type MotorBytes = readonly [
  leftDirection: number,
  leftSpeed: number,
  rightDirection: number,
  rightSpeed: number,
];

/**
 * Makes the controller, both motors standing.
 *
 * @param drive called after each write transfer that touched a motor register, with the offsets of those that it touched
 */
export function createController(drive: (bytes: MotorBytes, touched: Touched) => void): I2cTarget {
  return createRegisterMachine([
    memoryRegisters(MOTORS, 4, ([dirL = 0, speedL = 0, dirR = 0, speedR = 0], touched) =>
      drive([dirL, speedL, dirR, speedR], touched),
    ),
  ]);
}

/**
 * The Maqueen Lite's own controller: a register machine at I2C address 0x10 (see #devices/i2c-registers).
 *
 *      register  access  meaning
 *      0x00      RW      left motor direction, 0 forward, 1 backward
 *      0x01      RW      left motor speed, 0 … 255, takes effect at once
 *      0x02      RW      right motor direction
 *      0x03      RW      right motor speed
 *      0x14      RW      servo S1 angle, 0 … 180°
 *      0x15      RW      servo S2 angle
 *      0x32      R       length of the version text
 *      0x33 …    R       version text, ASCII
 *      others            those of the V5: see v5.ts; otherwise writes are ignored, reads give 0
 *
 * Sources: DFRobot pxt-maqueen `maqueen.ts` (3-byte motor writes, servo writes, `IR_read_version`), Tiger-Jython
 * Robotics-Libraries `mbrobot.py` (one 5-byte write for both motors).
 */
import type { I2cTarget } from '#board/wires/i2c-bus';
import { motorsTouched, type Side } from '#devices/dc-motor';
import { createRegisterMachine, memoryRegisters, textRegisters, type RegisterPart } from '#devices/i2c-registers';

export const CONTROLLER_ADDRESS = 0x10; // DFRobot pxt-maqueen: IIC address of the motor driver

const MOTORS = 0x00;
const SERVO_S1 = 0x14;
const SERVO_S2 = 0x15;
const VERSION_REGISTER = 0x32;

/** Chosen: product number and board version, in the form of the texts newer boards give (GBSL-Informatik/maqueen-plus-v2-mpy). */
export const VERSION = 'ROB0148-EN-4.0';

/** Direction and speed byte of one motor as the program set them. */
export interface MotorBytes {
  readonly direction: number;
  readonly speed: number;
}

/** The calls with which the controller drives its parts. */
export interface ControllerOutputs {
  /** Called after each write transfer that touched a motor register; `sides` are the motors that it touched. */
  motors(left: MotorBytes, right: MotorBytes, sides: readonly Side[]): void;
  /** Called after each write transfer that touched a servo register: port S1 or S2 and the byte, in degrees. */
  servo(port: 'S1' | 'S2', angleDeg: number): void;
}

/** Makes the controller, both motors standing. Register contents start at 0. `more` are the registers of further parts. */
export function createController(outputs: ControllerOutputs, more: readonly RegisterPart[] = []): I2cTarget {
  return createRegisterMachine([
    memoryRegisters(MOTORS, 4, ([dirL = 0, speedL = 0, dirR = 0, speedR = 0], touched) =>
      outputs.motors({ direction: dirL, speed: speedL }, { direction: dirR, speed: speedR }, motorsTouched(touched)),
    ),
    memoryRegisters(SERVO_S1, 1, ([angle = 0]) => outputs.servo('S1', angle)),
    memoryRegisters(SERVO_S2, 1, ([angle = 0]) => outputs.servo('S2', angle)),
    textRegisters(VERSION_REGISTER, VERSION),
    ...more,
  ]);
}

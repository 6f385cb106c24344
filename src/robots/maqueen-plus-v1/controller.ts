/**
 * The Maqueen Plus V1's own controller: a register machine at I2C address 0x10 (see #devices/i2c-registers).
 *
 *      register     access  meaning
 *      0x00         RW      left motor direction: 0 stop, 1 forward, 2 backward
 *      0x01         RW      left motor speed, 0 … 255, takes effect at once
 *      0x02         RW      right motor direction
 *      0x03         RW      right motor speed
 *      0x04, 0x05   RW      pulses of the left wheel since the start, high byte first; a write resets them to 0
 *      0x06, 0x07   RW      pulses of the right wheel
 *      0x0A         RW      speed control: 0 off, otherwise the controller keeps the speed (see speed-control.ts)
 *      0x0B         RW      left colour light: 1 red, 2 green, 3 yellow, 4 blue, 5 pink, 6 cyan, 7 white, others off
 *      0x0C         RW      right colour light
 *      0x14 … 0x16  RW      angle of servo S1, S2, S3 in degrees
 *      0x1D         R       line sensors: bit 0 = L3, 1 = L2, 2 = L1, 3 = R1, 4 = R2, 5 = R3; 1 on black, 0 on light ground
 *      0x1E … 0x29  R       brightness of L3, L2, L1, R1, R2, R3, two bytes each, high byte first
 *      0x32         R       length of the version text
 *      0x33 …       R       version text, ASCII
 *      others               writes are ignored, reads give 0
 *
 * Sources: DFRobot/pxt-DFRobot-Maqueenplus `maqueenplus.ts`, DFRobot/DFRobot_Maqueenplus `DFRobot_MaqueenPlus.cpp`,
 * Tiger-Jython/Robotics-Libraries `mbrobot_plus.py`, lawther/maqueenplus `maqueenplus.py`.
 */
import type { I2cTarget } from '#board/wires/i2c-bus';
import { motorsTouched, type Side as Motor } from '#devices/dc-motor';
import {
  bitsOf,
  byteOf,
  createRegisterMachine,
  liveRegisters,
  memoryRegisters,
  textRegisters,
  wordRegisters,
  type RegisterPart,
  type Touched,
} from '#devices/i2c-registers';
import type { Rgb } from '#core/rgb';
import { lampColor } from '../lamp-colors';

export const CONTROLLER_ADDRESS = 0x10; // DFRobot maqueenplus.ts

const MOTORS = 0x00;
const PULSES = 0x04;
const SPEED_CONTROL = 0x0a;
const LIGHTS = 0x0b;
const SERVOS = 0x14;
const LINE_BITS = 0x1d;
const LINE_VALUES = 0x1e;
const VERSION = 0x32;

/** lawther/maqueenplus drives robots whose text ends in 1.4; the product number is that of the series (see the V2). */
export const VERSION_TEXT = 'MBT0021-EN-1.4';

/** The line sensors from left to right: the order of their bits and values. */
export const LINE_NAMES = ['L3', 'L2', 'L1', 'R1', 'R2', 'R3'] as const;

/** A line sensor's name, as printed on the robot. */
export type LineName = (typeof LINE_NAMES)[number];

/** A wheel: 0 left, 1 right. */
export type Side = 0 | 1;

/** The calls with which the controller drives its parts and reads its sensors. */
export interface ControllerParts {
  /** Called after each write transfer that touched a motor: duties −1 … 1 from the bytes; `sides` were touched. */
  motors(left: number, right: number, sides: readonly Motor[]): void;
  speedControl(isOn: boolean): void;
  /** Called after each write transfer that touched a light, one or both: 0 left, 1 right. */
  lights(left: Rgb, right: Rgb, touched: Touched): void;
  /** Servo 0 … 2, angle in degrees. */
  servo(index: number, angleDeg: number): void;
  /** Pulses of a wheel since their last reset. */
  pulses(side: Side): number;
  clearPulses(side: Side): void;
  isBright(sensor: LineName): boolean;
  /** Brightness, 0 … 4095. */
  brightness(sensor: LineName): number;
}

/** Makes the controller; motors, lights and speed control are off. */
export function createController(parts: ControllerParts): I2cTarget {
  return createRegisterMachine([
    memoryRegisters(MOTORS, 4, ([dirL = 0, speedL = 0, dirR = 0, speedR = 0], touched) =>
      parts.motors(dutyOf(dirL, speedL), dutyOf(dirR, speedR), motorsTouched(touched)),
    ),
    pulseRegisters(parts),
    memoryRegisters(SPEED_CONTROL, 1, ([isOn = 0]) => parts.speedControl(isOn !== 0)),
    memoryRegisters(LIGHTS, 2, ([left = 0, right = 0], touched) =>
      parts.lights(lampColor(left), lampColor(right), touched),
    ),
    servoRegisters(parts),
    liveRegisters(LINE_BITS, 1, () => bitsOf(LINE_NAMES, (name) => !parts.isBright(name))),
    wordRegisters(LINE_VALUES, LINE_NAMES.length, 'high-first', (word) => {
      const name = LINE_NAMES[word];
      return name === undefined ? 0 : parts.brightness(name);
    }),
    textRegisters(VERSION, VERSION_TEXT),
  ]);
}

/** Two counting words; a write of any value resets them. */
function pulseRegisters(parts: ControllerParts): RegisterPart {
  return {
    first: PULSES,
    count: 4,
    read: (offset) => byteOf(parts.pulses(sideOf(offset)), offset % 2),
    write: (offset) => parts.clearPulses(sideOf(offset)),
  };
}

/** A byte per servo. Only a write turns a servo, so one that was never set stays where it is. */
function servoRegisters(parts: ControllerParts): RegisterPart {
  const angles = [0, 0, 0];
  return {
    first: SERVOS,
    count: angles.length,
    read: (offset) => angles[offset] ?? 0,
    write: (offset, angleDeg) => {
      angles[offset] = angleDeg;
      parts.servo(offset, angleDeg);
    },
  };
}

/** Duty of a motor, −1 … 1. Directions beyond 2 are not documented: chosen as stop. */
function dutyOf(direction: number, speed: number): number {
  if (speed === 0 || direction === 0 || direction > 2) return 0;
  return (direction === 1 ? speed : -speed) / 255;
}

const sideOf = (offset: number): Side => (offset < 2 ? 0 : 1);

/**
 * The MotionKit 2's own controller: a register machine at I2C address 0x10 (see #devices/i2c-registers).
 *
 *      register    access  meaning
 *      0x00        RW      left motor direction, 0 forward, 1 backward
 *      0x01        RW      left motor speed, 0 … 255, takes effect at once
 *      0x02        RW      right motor direction
 *      0x03        RW      right motor speed
 *      0x0B        RW      left light, 0 off, otherwise on
 *      0x0C        RW      right light
 *      0x14        RW      servo S1 angle, 0 … 180°
 *      0x15        RW      servo S2 angle
 *      0x18 … 0x1A RW      red, green, blue of the colour lights, 0 … 255: one colour for all of them
 *      0x1D        R       line sensors: bit 0 = left, 1 = right; 1 on black, 0 on light ground
 *      0x1E        R       brightness below the left line sensor, 0 … 255
 *      0x20        R       brightness below the right one
 *      0x28, 0x29  R       distance in cm, high byte, low byte; −1 (0xFFFF) with nothing in range, 0 without a value
 *      0x2B … 0x2E R       code of the infrared remote control, 32 bits, highest byte first; 0 = none heard
 *      0x32        R       length of the version text
 *      0x33 …      R       version text, ASCII
 *      others              writes are ignored, reads give 0
 *
 * Sources: chbijou/mpyCalliope `mpy_MotionKitV2/doc/I2CAdressenRegister.txt` (the list), tinysuperlab/MotionKitV2
 * `maqueen.ts`, Tiger-Jython/Robotics-Libraries `calliope/callimk.py`, calliope-edu/calliope-mini-python-editor
 * `MotionKitV2.py`. They contradict one another about left and right: see `SidesOf` and SOURCES.md.
 */
import type { I2cTarget } from '#board/wires/i2c-bus';
import type { Rgb } from '#core/rgb';
import { motorsTouched, type Side } from '#devices/dc-motor';
import {
  bitsOf,
  byteOf,
  createRegisterMachine,
  liveRegisters,
  memoryRegisters,
  textRegisters,
  wordRegisters,
} from '#devices/i2c-registers';

export const CONTROLLER_ADDRESS = 0x10; // all sources

const MOTORS = 0x00;
const LIGHTS = 0x0b;
const SERVO_S1 = 0x14;
const SERVO_S2 = 0x15;
const COLOR = 0x18;
const LINE_BITS = 0x1d;
const LINE_FIRST = 0x1e;
const LINE_SECOND = 0x20;
const DISTANCE = 0x28;
const INFRARED = 0x2b;
const VERSION_REGISTER = 0x32;

/** Chosen: the text is not published. The list gives it at most 20 characters. */
export const VERSION = 'MotionKit2-V1.0';

/** Direction and speed byte of one motor as the program set them. */
export interface MotorBytes {
  readonly direction: number;
  readonly speed: number;
}

/** The sides of two parts, in the order of their registers or bits. */
type Sides = readonly [first: Side, second: Side];

/** The side that each register belongs to. */
export interface SidesOf {
  readonly motors: Sides;
  readonly lights: Sides;
  readonly line: Sides;
}

const LEFT_FIRST: Sides = ['left', 'right'];
const RIGHT_FIRST: Sides = ['right', 'left'];

/** The readings of the sources, by the option `sides`. */
export const SIDES = {
  /** The maker (tinysuperlab/MotionKitV2) and chbijou's list. */
  maker: { motors: LEFT_FIRST, lights: LEFT_FIRST, line: LEFT_FIRST },
  /** ETH's callimk.py: its setLEDLeft writes 0x0C. */
  'lights-swapped': { motors: LEFT_FIRST, lights: RIGHT_FIRST, line: LEFT_FIRST },
  /** The Calliope editor's MotionKitV2.py. */
  'all-swapped': { motors: RIGHT_FIRST, lights: RIGHT_FIRST, line: RIGHT_FIRST },
} as const satisfies Readonly<Record<string, SidesOf>>;

/** The calls with which the controller drives its parts and reads its sensors. */
export interface ControllerParts {
  /** Called after each write transfer that touched a motor register; `sides` are the motors that it touched. */
  motors(bytes: Readonly<Record<Side, MotorBytes>>, sides: readonly Side[]): void;
  /** Called for each light that a write transfer touched. */
  light(side: Side, isLit: boolean): void;
  /** Called after each write transfer that touched a servo register: port S1 or S2 and the byte, in degrees. */
  servo(port: 'S1' | 'S2', angleDeg: number): void;
  /** Called after each write transfer that touched one of the three colours. */
  color(color: Rgb): void;
  isBright(side: Side): boolean;
  /** Brightness below a line sensor, 0 … 255. */
  brightness(side: Side): number;
  /** Reading of the ultrasonic sensor in whole cm; below 0 out of range. The two bytes of one transfer call it once each. */
  distanceCm(): number;
  /** The code that a remote control has sent, 32 bits; 0 = none. */
  infraredCode(): number;
}

/** Makes the controller; motors and lights are off. Register contents start at 0. */
export function createController(parts: ControllerParts, { motors, lights, line }: SidesOf): I2cTarget {
  return createRegisterMachine([
    memoryRegisters(MOTORS, 4, ([dir0 = 0, speed0 = 0, dir1 = 0, speed1 = 0], touched) => {
      const set: Record<Side, MotorBytes> = { left: { direction: 0, speed: 0 }, right: { direction: 0, speed: 0 } };
      set[motors[0]] = { direction: dir0, speed: speed0 };
      set[motors[1]] = { direction: dir1, speed: speed1 };
      const sides = motorsTouched(touched).map((side) => motors[side === 'left' ? 0 : 1]);
      parts.motors(set, sides);
    }),
    ...lights.map((side, i) => memoryRegisters(LIGHTS + i, 1, ([byte = 0]) => parts.light(side, byte > 0))),
    memoryRegisters(SERVO_S1, 1, ([angle = 0]) => parts.servo('S1', angle)),
    memoryRegisters(SERVO_S2, 1, ([angle = 0]) => parts.servo('S2', angle)),
    memoryRegisters(COLOR, 3, ([red = 0, green = 0, blue = 0]) => parts.color([red, green, blue])),
    liveRegisters(LINE_BITS, 1, () => bitsOf(line, (side) => !parts.isBright(side))),
    liveRegisters(LINE_FIRST, 1, () => parts.brightness(line[0])),
    liveRegisters(LINE_SECOND, 1, () => parts.brightness(line[1])),
    wordRegisters(DISTANCE, 1, 'high-first', () => parts.distanceCm()),
    liveRegisters(INFRARED, 4, (offset) => byteOf(parts.infraredCode(), offset, 4)),
    textRegisters(VERSION_REGISTER, VERSION),
  ]);
}

/**
 * The Calli:bot's own controller: three devices on the I2C bus.
 *
 * 0x20, motors and servos: write [register, data …] for that register and the following ones.
 *
 *      register  meaning
 *      0x00      left motor direction, 0 forward, 1 backward
 *      0x01      left motor power, 0 … 255; 0 brakes
 *      0x02      right motor direction
 *      0x03      right motor power
 *      0x14      servo S1 angle, 0 … 180°
 *      0x15      servo S2 angle
 *
 * 0x21, lights (write, as above) and sensors (read, always from the first byte).
 *
 *      write 0x00         red lights, bit 0 left, bit 1 right
 *      write 0x01 … 0x04  colour lights front left, rear left, rear right, front right: see `oldColor`
 *      read byte 0        the switches: see `Inputs`; bit 7 is 1, on a Calli:bot 1 it is 0
 *      read bytes 1, 2    distance in mm, high byte first
 *
 * 0x22, registers (not on a Calli:bot 1): write [register, data …]; a read gives the contents of the register written
 * last.
 *
 *      0x01  W  motors and lights off, servos without a signal
 *      0x02  W  [mask, direction, power] or [3, direction, power, direction, power]; mask 1 left, 2 right, 3 both
 *      0x03  W  [light, brightness] or [light, red, green, blue], 0 … 16; 1 … 4 colour lights as above, 5 red left,
 *               6 red right; 0 power and 7, 8 line sensor lights: accepted, without effect
 *      0x05  W  [mask] encoders to 0, 1 left, 2 right, 3 both (2E)
 *      0x80  R  the switches, bit 7 is 0; every register that is not in this table gives the same
 *      0x81  R  [0x81, low, high] distance in mm
 *      0x82  R  [0x82, type, firmware 4 bytes, serial number 4 bytes]; type 2 = Calli:bot 2, 3 = 2E
 *      0x83  R  [0x83, low, high] supply voltage in mV (2E)
 *      0x84  R  [0x84, right low, right high, left low, left high] line sensors in mV
 *      0x91  R  [0x91, left 4 bytes, right 4 bytes] encoders, signed, lowest byte first (2E)
 *
 * Sources: Knotech "Calli:bot und Calli:bot2 Steuercodes" (12.11.2021; in chbijou/mpyCalliope), knotechgmbh/Callibot2
 * `knotech2.ts`, calliope-net/callibot2 `sensoren.ts` (types, encoders), Pegasus2105/callibot-ESP32 (old colour byte).
 */
import type { I2cTarget } from '#board/wires/i2c-bus';
import type { Rgb } from '#core/rgb';
import { BOTH_SIDES, motorsTouched, type Side } from '#devices/dc-motor';
import { createRegisterMachine, type RegisterPart } from '#devices/i2c-registers';

export const MOTORS_ADDRESS = 0x20;
export const LIGHTS_ADDRESS = 0x21;
export const REGISTERS_ADDRESS = 0x22;

/**
 * Further addresses that a scan finds on a robot with 0x22; their purpose is unknown. chbijou/mpyCalliope
 * `mpy_Callibot2/34_i2cs_can.py`, on a Calliope mini 3; Pegasus2105/callibot-ESP32, on an ESP32.
 */
export const SILENT_ADDRESSES = [0x23, 0x24, 0x25, 0x26, 0x27] as const;

/** The supported models of the Calli:bot, oldest first. */
export type Model = '1' | '2' | '2E';

/** The program's setting for one motor. */
export interface MotorBytes {
  readonly direction: number;
  readonly power: number;
}

/** The parts that the controller drives and reads. */
export interface ControllerParts {
  /** Called after each write transfer that touched a motor; `sides` are those that it touched. */
  motors(left: MotorBytes, right: MotorBytes, sides: readonly Side[]): void;
  servo(port: 'S1' | 'S2', angleDeg: number): void;
  redLight(side: Side, isLit: boolean): void;
  /** @param index 0 front left, 1 rear left, 2 rear right, 3 front right; parts of the colour 0 … 255 */
  colorLight(index: number, color: Rgb): void;
  isBright(side: Side): boolean;
  /** True if this half of the bumper is pressed. Called whenever a program reads the byte that reports it. */
  isPressed(side: Side): boolean;
  /** Output of a line sensor in mV. */
  lineMv(side: Side): number;
  /** Reading of the ultrasonic sensor, in mm. */
  distanceMm(): number;
  supplyMv(): number;
  /** Pulses since the start, negative backward. */
  pulses(side: Side): number;
}

/** The devices on the bus; a Calli:bot 1 has no `registers`. */
export interface Controller {
  readonly motors: I2cTarget;
  readonly lights: I2cTarget;
  readonly registers: I2cTarget | null;
}

/** Makes the controller; motors and lights are off. */
export function createController(parts: ControllerParts, model: Model): Controller {
  const motorBytes = new Uint8Array(4); // left direction, left power, right direction, right power
  const tellMotors = (sides: readonly Side[]): void => {
    const [dirL = 0, powerL = 0, dirR = 0, powerR = 0] = motorBytes;
    parts.motors({ direction: dirL, power: powerL }, { direction: dirR, power: powerR }, sides);
  };
  const motors = createRegisterMachine([motorRegisters(motorBytes, tellMotors), servoRegisters(parts)]);
  return {
    motors,
    lights: createLights(parts, model),
    registers: model === '1' ? null : createRegisters({ parts, model, motorBytes, tellMotors }),
  };
}

function motorRegisters(bytes: Uint8Array, tell: (sides: readonly Side[]) => void): RegisterPart {
  return {
    first: 0x00,
    count: bytes.length,
    read: (offset) => bytes[offset] ?? 0, // chosen: Knotech's sheet has no reading at 0x20
    write: (offset, byte) => void (bytes[offset] = byte),
    written: (touched) => tell(motorsTouched(touched)),
  };
}

function servoRegisters(parts: ControllerParts): RegisterPart {
  const angles = new Uint8Array(2);
  return {
    first: 0x14,
    count: angles.length,
    read: (offset) => angles[offset] ?? 0,
    write: (offset, byte) => {
      angles[offset] = byte;
      parts.servo(offset === 0 ? 'S1' : 'S2', byte);
    },
  };
}

const COLOR_LIGHTS = 4;

function createLights(parts: ControllerParts, model: Model): I2cTarget {
  const red: RegisterPart = { first: 0, count: 1, read: () => 0, write: (_, mask) => setRedLights(parts, mask) };
  const colors: RegisterPart = {
    first: 1,
    count: COLOR_LIGHTS,
    read: () => 0,
    write: (index, byte) => parts.colorLight(index, oldColor(byte)),
  };
  const writes = createRegisterMachine([red, colors]);
  return {
    write: (bytes) => writes.write(bytes),
    read: (count) => {
      const isNew = model === '1' ? 0 : Inputs.isCallibot2;
      const distance = count > 1 ? parts.distanceMm() : 0; // looking costs time
      return firstOf([inputs(parts, model) | isNew, ...lowHigh(distance).reverse()], count);
    },
  };
}

/** Bits of the byte of switches; 1 = bright, pressed. The keys ON and OFF (16, 32) are never pressed here. */
const Inputs = { lineRight: 1, lineLeft: 2, bumperRight: 4, bumperLeft: 8, isCallibot2: 128 } as const;

function inputs(parts: ControllerParts, model: Model): number {
  const line = (parts.isBright('right') ? Inputs.lineRight : 0) | (parts.isBright('left') ? Inputs.lineLeft : 0);
  if (model === '1') return line;
  return line | (parts.isPressed('right') ? Inputs.bumperRight : 0) | (parts.isPressed('left') ? Inputs.bumperLeft : 0);
}

function setRedLights(parts: ControllerParts, mask: number): void {
  parts.redLight('left', (mask & 1) !== 0);
  parts.redLight('right', (mask & 2) !== 0);
}

const FULL = 255;

/**
 * The colour byte of the first Calli:bot: bit 0 green, bit 1 red, bit 2 blue; bits 4 … 7 brightness, 0 … 15
 * (Pegasus2105/callibot-ESP32; the colours of knotech2.ts agree).
 */
function oldColor(byte: number): Rgb {
  const level = Math.round(((byte >> 4) * FULL) / 15);
  return [byte & 2 ? level : 0, byte & 1 ? level : 0, byte & 4 ? level : 0];
}

/** Brightness 0 … 16 of register 0x03 as 0 … 255; more than 16 is as bright as 16: chosen. */
const fullScale = (level: number): number => Math.round((Math.min(level, 16) * FULL) / 16);

interface RegisterSetup {
  readonly parts: ControllerParts;
  readonly model: Model;
  readonly motorBytes: Uint8Array;
  readonly tellMotors: (sides: readonly Side[]) => void;
}

const TYPE_NUMBERS: Readonly<Record<Model, number>> = { '1': 1, '2': 2, '2E': 3 }; // calliope-net/callibot2 sensoren.ts

/** Firmware "1.2 - 3.4" in the order in which it is sent, and serial number: chosen, no source gives any. */
const FIRMWARE = [4, 3, 2, 1] as const;
const SERIAL_NUMBER = [0, 0, 0, 1] as const;

function createRegisters(setup: RegisterSetup): I2cTarget {
  const { parts, model, motorBytes, tellMotors } = setup;
  const zeroPulses = { left: 0, right: 0 };
  const hasEncoders = model === '2E';
  let selected = 0x80;

  const write: Readonly<Record<number, (data: Uint8Array) => void>> = {
    0x01: () => {
      motorBytes.fill(0);
      tellMotors(BOTH_SIDES);
      setRedLights(parts, 0);
      for (let index = 0; index < COLOR_LIGHTS; index++) parts.colorLight(index, [0, 0, 0]);
    },
    0x02: ([mask = 0, ...pairs]) => {
      const both = (mask & 3) === 3;
      if (mask & 1) motorBytes.set(pairs.slice(0, 2), 0);
      // A single pair for two motors sets both: chosen, the sheet always sends two.
      if (mask & 2) motorBytes.set(both && pairs.length > 2 ? pairs.slice(2, 4) : pairs.slice(0, 2), 2);
      if (mask & 3) tellMotors(BOTH_SIDES.filter((_, bit) => (mask & (1 << bit)) !== 0));
    },
    0x03: ([light = 0, ...levels]) => {
      const [red = 0, green = 0, blue = 0] = levels.map(fullScale);
      if (light >= 1 && light <= COLOR_LIGHTS) parts.colorLight(light - 1, [red, green, blue]);
      if (light === 5) parts.redLight('left', red > 0);
      if (light === 6) parts.redLight('right', red > 0);
    },
    0x05: ([mask = 0]) => {
      if (!hasEncoders) return;
      if (mask & 1) zeroPulses.left = parts.pulses('left');
      if (mask & 2) zeroPulses.right = parts.pulses('right');
    },
  };

  const answer = (): readonly number[] => {
    if (selected === 0x81) return [0x81, ...lowHigh(parts.distanceMm())];
    if (selected === 0x82) return [0x82, TYPE_NUMBERS[model], ...FIRMWARE, ...SERIAL_NUMBER];
    if (selected === 0x84) return [0x84, ...lowHigh(parts.lineMv('right')), ...lowHigh(parts.lineMv('left'))];
    if (selected === 0x83 && hasEncoders) return [0x83, ...lowHigh(parts.supplyMv())];
    if (selected === 0x91 && hasEncoders) {
      const since = (side: Side): readonly number[] => int32(parts.pulses(side) - zeroPulses[side]);
      return [0x91, ...since('left'), ...since('right')];
    }
    return [inputs(parts, model)];
  };

  return {
    write: (bytes) => {
      if (bytes.length === 0) return; // an address probe
      selected = bytes[0] ?? 0;
      write[selected]?.(bytes.subarray(1));
    },
    read: (count) => firstOf(answer(), count),
  };
}

/** The first bytes of an answer; 0 beyond its end: chosen. */
function firstOf(answer: readonly number[], count: number): Uint8Array {
  const bytes = new Uint8Array(count);
  bytes.set(answer.slice(0, count));
  return bytes;
}

const lowHigh = (value: number): number[] => [value & 0xff, (value >> 8) & 0xff];

const int32 = (value: number): readonly number[] => [0, 8, 16, 24].map((shift) => (value >> shift) & 0xff);

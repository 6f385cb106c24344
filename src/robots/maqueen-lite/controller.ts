/**
 * The Maqueen Lite's own controller: a register machine at I2C address 0x10.
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
 *      others            writes are ignored, reads give 0
 *
 * A write is a register number followed by data for it and the following registers. A read continues at the register
 * selected by the last write.
 * Sources: DFRobot pxt-maqueen `maqueen.ts` (3-byte motor writes, servo writes, `IR_read_version`), Tiger-Jython
 * Robotics-Libraries `mbrobot.py` (one 5-byte write for both motors).
 */
import type { I2cTarget } from '#board/i2c-bus';

export const CONTROLLER_ADDRESS = 0x10; // DFRobot pxt-maqueen: IIC address of the motor driver

const LEFT_DIRECTION = 0x00;
const LEFT_SPEED = 0x01;
const RIGHT_DIRECTION = 0x02;
const RIGHT_SPEED = 0x03;
const SERVO_S1 = 0x14;
const SERVO_S2 = 0x15;
const VERSION_LENGTH = 0x32;
const VERSION_TEXT = 0x33;
const REGISTER_COUNT = 256;

/** Chosen: product number and board version, in the form of the texts newer boards give (GBSL-Informatik/maqueen-plus-v2-mpy). */
export const VERSION = 'ROB0148-EN-4.0';

/** Direction and speed byte of one motor as the program set them. */
export interface MotorBytes {
  readonly direction: number;
  readonly speed: number;
}

/** What the controller tells the parts it drives. */
export interface ControllerOutputs {
  /** Called after each write transfer that touched a motor register. */
  motors(left: MotorBytes, right: MotorBytes): void;
  /** Called when a servo register is written: port S1 or S2 and the byte, meant as degrees. */
  servo(port: 'S1' | 'S2', angleDeg: number): void;
}

/** Makes the controller, both motors standing. Register contents start at 0. */
export function createController(outputs: ControllerOutputs): I2cTarget {
  const registers = new Uint8Array(REGISTER_COUNT);
  registers[VERSION_LENGTH] = VERSION.length;
  for (let i = 0; i < VERSION.length; i++) registers[VERSION_TEXT + i] = VERSION.charCodeAt(i);
  let selected = 0;

  const motor = (directionRegister: number, speedRegister: number): MotorBytes => ({
    direction: registers[directionRegister] ?? 0,
    speed: registers[speedRegister] ?? 0,
  });

  return {
    write: (bytes) => {
      if (bytes.length === 0) return; // an address probe
      selected = bytes[0] ?? 0;
      let touchedMotor = false;
      for (const byte of bytes.subarray(1)) {
        if (isWritable(selected)) registers[selected] = byte;
        if (selected <= RIGHT_SPEED) touchedMotor = true;
        if (selected === SERVO_S1) outputs.servo('S1', byte);
        if (selected === SERVO_S2) outputs.servo('S2', byte);
        selected = (selected + 1) % REGISTER_COUNT;
      }
      if (touchedMotor) outputs.motors(motor(LEFT_DIRECTION, LEFT_SPEED), motor(RIGHT_DIRECTION, RIGHT_SPEED));
    },
    read: (count) => {
      const answer = new Uint8Array(count);
      for (let i = 0; i < count; i++) {
        answer[i] = registers[selected] ?? 0;
        selected = (selected + 1) % REGISTER_COUNT;
      }
      return answer;
    },
  };
}

/** The version cannot be overwritten; a register without a meaning keeps reading as 0. */
function isWritable(register: number): boolean {
  return register <= RIGHT_SPEED || register === SERVO_S1 || register === SERVO_S2;
}

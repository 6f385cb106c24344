/**
 * The Cutebot's own controller at I2C address 0x10. It takes frames of four bytes, one for each thing:
 *
 *      frame                      meaning
 *      1, direction, speed, 0     left motor: direction 2 forward, 1 backward; speed 0 … 100
 *      2, direction, speed, 0     right motor
 *      4, red, green, blue        left headlamp, 0 … 255 each
 *      8, red, green, blue        right headlamp
 *      5, angle, 0, 0             servo S1, 0 … 180°
 *      6, angle, 0, 0             servo S2
 *
 * Sources: elecfreaks/EF_Produce_MicroPython `Cutebot.py`, elecfreaks/pxt-cutebot `cutebot.ts`,
 * vittascience/microbit-libraries `cutebot.py`. Which headlamp is 4: SOURCES.md. Chosen, because no source says it: other
 * frames are ignored, a speed beyond 100 counts as 100, and a read finds the bus released.
 */
import type { I2cTarget } from '#board/wires/i2c-bus';
import type { Side } from '#devices/dc-motor';
import type { Rgb } from '#core/rgb';

export const CONTROLLER_ADDRESS = 0x10; // elecfreaks/pxt-cutebot cutebot.ts

const FRAME_BYTES = 4;

const BACKWARD = 1;
const FORWARD = 2;
const FULL_SPEED = 100;

const NOTHING = new Uint8Array(0);

/** The calls with which the controller drives its parts. */
export interface ControllerOutputs {
  /** Duty −1 … 1. */
  motor(side: Side, duty: number): void;
  headlamp(side: Side, color: Rgb): void;
  /** Angle in degrees, 0 … 255 as sent. */
  servo(port: 'S1' | 'S2', angleDeg: number): void;
}

/** Makes the controller. It sets nothing by itself. */
export function createController(outputs: ControllerOutputs): I2cTarget {
  const write = (bytes: Uint8Array): void => {
    if (bytes.length !== FRAME_BYTES) return;
    const [part = 0, first = 0, second = 0, third = 0] = bytes;
    switch (part) {
      case 1:
        return drive(outputs, 'left', first, second);
      case 2:
        return drive(outputs, 'right', first, second);
      case 4:
        return outputs.headlamp('left', [first, second, third]);
      case 8:
        return outputs.headlamp('right', [first, second, third]);
      case 5:
        return outputs.servo('S1', first);
      case 6:
        return outputs.servo('S2', first);
    }
  };
  return { write, read: () => NOTHING };
}

function drive(outputs: ControllerOutputs, side: Side, direction: number, speed: number): void {
  if (direction !== FORWARD && direction !== BACKWARD) return;
  const share = Math.min(speed, FULL_SPEED) / FULL_SPEED;
  outputs.motor(side, direction === FORWARD || share === 0 ? share : -share);
}

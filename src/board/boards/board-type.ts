import type { BoardApi, Feature } from '#core/board-api';

/** Current use of a pin, in the words of the device's `get_mode()`. */
export type PinMode =
  | 'unused'
  | 'read_digital'
  | 'write_digital'
  | 'write_analog'
  | 'touch'
  | 'music'
  | 'audio'
  | 'display'
  | 'button'
  | 'i2c'
  | 'spi';

/** Method by which a pin senses a finger: through a loop over ground, or by its charge. */
export type TouchKind = 'resistive' | 'capacitive';

/** One pin of a board, as a Python program knows it. */
export interface PinType {
  /** Python name: `pin0`, `pin_logo`. */
  readonly name: string;
  /** Name of its wire: the edge connector's `P0` … `P20`, otherwise a name of its own (`logo`, `speaker`). */
  readonly wire: string;
  /** The number in the device's message "Pin %d in %q mode". */
  readonly number: number;
  /** False for a pad that can only be touched. */
  readonly digital: boolean;
  /** True when `read_analog` exists. Every digital pin can write analog. */
  readonly analog: boolean;
  readonly touch: TouchKind | null;
  /** The board's own use of the pin after a start; `unused` for a free pin. */
  readonly startMode: PinMode;
}

/** Costs in simulated µs. Each board names the source of every row. */
export interface BoardCosts {
  /** One MicroPython bytecode. */
  readonly bytecodeUs: number;
  /** One object put on the heap, on top of its bytecode. */
  readonly allocationUs: number;
  /** A call of the device's own modules that has no row of its own. */
  readonly callUs: number;
  /** One `read_analog`. */
  readonly analogReadUs: number;
  /** One pixel of an image that is copied, moved or turned round. */
  readonly pixelMoveUs: number;
  /** One pixel of a sum or difference of two images. */
  readonly pixelSumUs: number;
  /** One pixel of an image times a number. */
  readonly pixelScaleUs: number;
  /** One pixel of an image that is read from text or written as text. */
  readonly pixelTextUs: number;
  /** A picture put on the display. */
  readonly showUs: number;
  /** One value of a motion sensor: acceleration, gesture, compass. */
  readonly motionUs: number;
  /** `scale(…)`. */
  readonly scaleUs: number;
  /** One LED of a NeoPixel whose colour is set or asked for. */
  readonly neopixelUs: number;
  /** A tone that begins. */
  readonly toneUs: number;
  /** One byte sent to the console. */
  readonly printByteUs: number;
  /** The pause between two transfers on the I2C bus; part of `I2cBus.transferUs`. */
  readonly i2cGapUs: number;
  /** An I2C write of no bytes to a chip that answers (what `i2c.scan` does); replaces the transfer time. */
  readonly i2cProbeUs: number;
  /** One byte of an LED stream (three bytes are one LED). */
  readonly ws2812ByteUs: number;
  /** Cost of every LED stream besides its bytes. */
  readonly ws2812SetupUs: number;
  /** One packet sent by radio. */
  readonly radioPacketUs: number;
  /** A line of the data log, besides its bytes. */
  readonly logLineUs: number;
  /** A byte of the data log. */
  readonly logByteUs: number;
}

/** The fields of `os.uname()`. */
export interface Uname {
  readonly sysname: string;
  readonly nodename: string;
  readonly release: string;
  readonly version: string;
  readonly machine: string;
}

/**
 * Behaviour of calls that firmwares after v2.1.2 have:
 *
 * - `clear-ends`: `display.clear()` ends what moves, and waits for the display's tick (commit a5dd649)
 * - `stop-ends-effects`: `audio.stop()` also ends built-in sounds and effects, not samples alone (c143b24)
 * - `return-pin`: `audio.play` takes a `return_pin`, and does nothing with it (15b467c)
 * - `i2c-pins`: `i2c.init` moves the bus to other pins (ee75741)
 */
export type Change = 'clear-ends' | 'stop-ends-effects' | 'return-pin' | 'i2c-pins';

/** A MicroPython that a board can run. */
export interface FirmwareType {
  /** Option value: `v2.1.2`. */
  readonly id: string;
  /** Its name for users. */
  readonly name: string;
  readonly features: readonly Feature[];
  readonly changes: readonly Change[];
  /** Its greeting in the REPL. */
  readonly banner: string;
  readonly uname: Uname;
  /** `sys.version`. */
  readonly sysVersion: string;
  /** `sys.implementation.version`. */
  readonly micropython: readonly [number, number, number];
}

/** One motor connector: a pin for the direction (0 is forwards), a pin for the speed (its PWM duty). */
export interface MotorOutputType {
  readonly name: string;
  /** Python names of its pins. */
  readonly dirPin: string;
  readonly speedPin: string;
}

/** A microcomputer board as data. */
export interface BoardType {
  /** File name and option value: `microbit-v2`. */
  readonly id: string;
  /** Its name for users. */
  readonly name: string;
  /** The names that its Python offers: what help and completion show. */
  readonly api: BoardApi;
  /** Python names of the board's module; all of them are the same module, which calls itself by the first. */
  readonly modules: readonly string[];
  /** The firmwares it can run, the default first. */
  readonly firmwares: readonly [FirmwareType, ...FirmwareType[]];
  readonly pins: readonly PinType[];
  /** True if it ends in the micro:bit's edge connector: five rings, and the contacts between them. */
  readonly edgeConnector: boolean;
  /** Python names of the pins of the two buttons. */
  readonly buttons: { readonly a: string; readonly b: string };
  /** Python names of the pins that the display's columns share. */
  readonly displayPins: readonly string[];
  /** Python names of the I2C pins and the bus clock after a start, in Hz. */
  readonly i2c: { readonly scl: string; readonly sda: string; readonly frequencyHz: number };
  /** Python name of the pin for music, unless the program names another. */
  readonly musicPin: string;
  /** RGB LEDs (ws2812) soldered to the board: the Python name of their pin, and how many. */
  readonly rgb: { readonly pin: string; readonly count: number } | null;
  /** The board's own motor driver: while the Python pin `modePin` is high, its pins are direction and speed. */
  readonly motors: { readonly modePin: string; readonly outputs: readonly MotorOutputType[] } | null;
  readonly costsUs: BoardCosts;
}

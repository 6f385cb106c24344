import type { BoardType, FirmwareType, PinMode, PinType, TouchKind } from './board-type';
import { nrf52833CostsUs } from './nrf52833-costs';

/**
 * BBC micro:bit V2 (nRF52833) with MicroPython v2.1.2.
 * Sources: micro:bit V2 edge connector sheet (tech.microbit.org/hardware/edgeconnector);
 * micropython-microbit-v2, microbit_pin.c (which pin does what) and microbit_pinmode.c (what may be taken).
 */
function edgePin(number: number, startMode: PinMode, abilities: { analog?: boolean; touch?: TouchKind } = {}): PinType {
  return {
    name: `pin${number}`,
    wire: `P${number}`,
    number,
    digital: true,
    analog: abilities.analog ?? false,
    touch: abilities.touch ?? null,
    startMode,
  };
}

const pins: readonly PinType[] = [
  edgePin(0, 'unused', { analog: true, touch: 'resistive' }),
  edgePin(1, 'unused', { analog: true, touch: 'resistive' }),
  edgePin(2, 'unused', { analog: true, touch: 'resistive' }),
  edgePin(3, 'display', { analog: true }),
  edgePin(4, 'display', { analog: true }),
  edgePin(5, 'button'),
  edgePin(6, 'display'),
  edgePin(7, 'display'),
  edgePin(8, 'unused'),
  edgePin(9, 'unused'),
  edgePin(10, 'display', { analog: true }),
  edgePin(11, 'button'),
  edgePin(12, 'unused'),
  edgePin(13, 'unused'),
  edgePin(14, 'unused'),
  edgePin(15, 'unused'),
  edgePin(16, 'unused'),
  edgePin(19, 'i2c'),
  edgePin(20, 'i2c'),
  // The numbers 30 and 31 are those of microbit_pin.c.
  {
    name: 'pin_logo',
    wire: 'logo',
    number: 30,
    digital: false,
    analog: false,
    touch: 'capacitive',
    startMode: 'unused',
  },
  { name: 'pin_speaker', wire: 'speaker', number: 31, digital: true, analog: false, touch: null, startMode: 'unused' },
];

/**
 * The firmwares of the micro:bit. The words of v2.1.2 are those of the hex that the official editor ships
 * (python-editor-v3, src/micropython/main); those of the newest one are from micropython-microbit-v2 (mpconfigport.h,
 * modos.c), which has not been released: date and hash are those of that commit.
 */
const firmwares: readonly [FirmwareType, FirmwareType] = [
  {
    id: 'v2.1.2',
    name: 'MicroPython v2.1.2',
    features: [],
    changes: [],
    banner: 'MicroPython v1.18 on 2023-10-30; micro:bit v2.1.2 with nRF52833',
    uname: {
      sysname: 'microbit',
      nodename: 'microbit',
      release: '2.1.2',
      version: 'micro:bit v2.1.2+0697c6d on 2023-10-30; MicroPython v1.18 on 2023-10-30',
      machine: 'micro:bit with nRF52833',
    },
    sysVersion: '3.4.0; MicroPython v1.18 on 2023-10-30',
    micropython: [1, 18, 0],
  },
  {
    id: 'newest',
    name: 'MicroPython (newest)',
    features: ['rotate', 'sound-level-db', 'touch-counts', 'clap', 'recording'],
    changes: ['clear-ends', 'stop-ends-effects', 'return-pin', 'i2c-pins'],
    banner: 'MicroPython v1.23.0 on 2024-06-02; micro:bit v2.1.2 with nRF52833',
    uname: {
      sysname: 'microbit',
      nodename: 'microbit',
      release: '2.1.2',
      version: 'micro:bit v2.1.2+3f22f30 on 2024-06-02; MicroPython v1.23.0 on 2024-06-02',
      machine: 'micro:bit with nRF52833',
    },
    sysVersion: '3.4.0; MicroPython v1.23.0 on 2024-06-02',
    micropython: [1, 23, 0],
  },
];

/** The micro:bit V2: 19 edge pins, logo, speaker, two buttons, 5 × 5 LEDs. */
export const microbitV2: BoardType = {
  id: 'microbit-v2',
  name: 'micro:bit V2',
  api: 'microbit-v2',
  modules: ['microbit'],
  firmwares,
  pins,
  edgeConnector: true,
  buttons: { a: 'pin5', b: 'pin11' },
  displayPins: ['pin3', 'pin4', 'pin6', 'pin7', 'pin10'],
  i2c: { scl: 'pin19', sda: 'pin20', frequencyHz: 100_000 },
  musicPin: 'pin0',
  rgb: null,
  motors: null,
  costsUs: nrf52833CostsUs,
};

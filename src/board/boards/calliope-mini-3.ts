import type { BoardType, FirmwareType, PinMode, PinType, TouchKind } from './board-type';
import { nrf52833CostsUs } from './nrf52833-costs';

/**
 * Calliope mini 3 (nRF52833) with MicroPython v2.1.2b.
 * Sources: calliope-edu/micropython-calliope-mini-v3, src/codal_port/microbit_pin.c (which pin does what, its number),
 * modmicrobit.c (their names), src/codal_app/microbithal.cpp (four touch pads and the logo); Calliope mini 3 pinout.
 */
function pin(
  name: string,
  wire: string,
  number: number,
  abilities: { mode?: PinMode; analog?: boolean; touch?: TouchKind } = {},
): PinType {
  const { mode = 'unused', analog = false, touch = null } = abilities;
  return { name, wire, number, digital: true, analog, touch, startMode: mode };
}

const touchPin = (number: number): PinType =>
  pin(`pin${number}`, `P${number}`, number, { analog: true, touch: 'resistive' });

const pins: readonly PinType[] = [
  touchPin(0),
  touchPin(1),
  touchPin(2),
  touchPin(3),
  pin('pin4', 'P4', 4, { analog: true, mode: 'display' }),
  pin('pin5', 'P5', 5, { mode: 'button' }),
  pin('pin6', 'P6', 6, { mode: 'display' }),
  pin('pin7', 'P7', 7, { mode: 'display' }),
  pin('pin8', 'P8', 8),
  pin('pin9', 'P9', 9),
  pin('pin10', 'P10', 10, { analog: true, mode: 'display' }),
  pin('pin11', 'P11', 11, { mode: 'button' }),
  pin('pin12', 'P12', 12),
  pin('pin13', 'P13', 13),
  pin('pin14', 'P14', 14),
  pin('pin15', 'P15', 15),
  // The two Grove connectors: A1 is serial or analog, A0 is the I2C bus.
  pin('pin_A1_RX', 'P16', 16, { analog: true }),
  pin('pin_A1_TX', 'P17', 17),
  pin('pin18', 'P18', 18, { mode: 'display' }),
  pin('pin_A0_SCL', 'P19', 19, { mode: 'i2c' }),
  pin('pin_A0_SDA', 'P20', 20, { mode: 'i2c' }),
  pin('pin_RGB', 'RGB', 21),
  pin('pin_M0_DIR', 'M0_DIR', 22),
  pin('pin_M0_SPEED', 'M0_SPEED', 23),
  pin('pin_M1_DIR', 'M1_DIR', 24),
  pin('pin_M1_SPEED', 'M1_SPEED', 25),
  pin('pin_M_MODE', 'M_MODE', 26),
  {
    name: 'pin_logo',
    wire: 'logo',
    number: 30,
    digital: false,
    analog: false,
    touch: 'capacitive',
    startMode: 'unused',
  },
  pin('pin_speaker', 'speaker', 31),
];

/** The words of the hex that the official editor ships (calliope-mini-python-editor, src/micropython/main). */
const firmware: FirmwareType = {
  id: 'v2.1.2b',
  name: 'MicroPython v2.1.2b',
  features: ['rotate', 'sound-level-db', 'touch-counts', 'clap'],
  changes: ['clear-ends', 'stop-ends-effects', 'return-pin', 'i2c-pins'],
  banner: 'MicroPython b7ce7a8 on 2024-11-05; Calliope mini v2.1.2b with nRF52833',
  uname: {
    sysname: 'microbit',
    nodename: 'microbit',
    release: '2.1.2b',
    version: 'micro:bit v2.1.2b+5d837a8 on 2024-11-05; MicroPython b7ce7a8 on 2024-11-05',
    machine: 'Calliope mini with nRF52833',
  },
  sysVersion: '3.4.0; MicroPython b7ce7a8 on 2024-11-05',
  micropython: [1, 23, 0],
};

/** The Calliope mini 3: four touch pads, logo, speaker, two buttons, 5 × 5 LEDs, three RGB LEDs, two motor outputs. */
export const calliopeMini3: BoardType = {
  id: 'calliope-mini-3',
  name: 'Calliope mini 3',
  api: 'calliope-mini-3',
  modules: ['calliopemini', 'calliope_mini', 'microbit'],
  firmwares: [firmware],
  pins,
  edgeConnector: false,
  buttons: { a: 'pin5', b: 'pin11' },
  displayPins: ['pin4', 'pin6', 'pin7', 'pin10', 'pin18'],
  i2c: { scl: 'pin_A0_SCL', sda: 'pin_A0_SDA', frequencyHz: 100_000 },
  musicPin: 'pin0',
  rgb: { pin: 'pin_RGB', count: 3 },
  motors: {
    modePin: 'pin_M_MODE',
    outputs: [
      { name: 'M0', dirPin: 'pin_M0_DIR', speedPin: 'pin_M0_SPEED' },
      { name: 'M1', dirPin: 'pin_M1_DIR', speedPin: 'pin_M1_SPEED' },
    ],
  },
  costsUs: nrf52833CostsUs,
};

import type { BoardCosts, BoardType, PinMode, PinType, TouchKind } from '../board-type';

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

const costsUs: BoardCosts = {
  bytecodeUs: 1, // fitted together with allocationUs to the next row's measurement
  allocationUs: 9, // fitted: 13,700 rounds of `number = number * 1.001 - 1.001` take 442 ms (kevinjwalters/micropython-examples)
  callUs: 5, // chosen: a C function of a few hundred instructions at 64 MHz
  analogReadUs: 91, // codal-nrf52 NRF52ADC.cpp: time of one channel's 14-bit conversion
  printByteUs: 1_000_000 / 11_520, // 115200 baud, ten bits a byte: 86.8 µs
  i2cGapUs: 10, // codal-nrf52 NRF52I2C.cpp asks every 10 µs whether a transfer is done
  i2cProbeUs: 1000, // codal-nrf52 NRF52I2C.cpp: a transfer without bytes ends by its 1 ms time-out
  ws2812ByteUs: 10, // WS2812B datasheet: 1.25 µs a bit, hence 30 µs an LED
  ws2812SetupUs: 125, // measured by users, micropython-microbit-v2 issue #227: 125 … 300 µs besides the bits
};

/** The micro:bit V2: 19 edge pins, logo, speaker, two buttons, 5 × 5 LEDs. */
export const microbitV2: BoardType = {
  id: 'microbit-v2',
  name: 'micro:bit V2',
  pins,
  buttons: { a: 'pin5', b: 'pin11' },
  displayPins: ['pin3', 'pin4', 'pin6', 'pin7', 'pin10'],
  i2c: { scl: 'pin19', sda: 'pin20', frequencyHz: 100_000 },
  musicPin: 'pin0',
  costsUs,
};

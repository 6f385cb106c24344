/**
 * A colour sensor TCS34725 on the I2C bus: four light meters, for all light and for red, green and blue, and a lamp beside
 * them that shines on what is to be seen.
 *
 *      write  [1 tt aaaaa, data …]   command with the register a: t = 00 the same one again and again, 01 it moves along,
 *                                    11 a function (6: the interrupt is over); data is for that register
 *      read   n bytes                from the register that was named
 *
 *      register      meaning
 *      00 ENABLE     1 on, 2 measure, 8 wait between two measurements, 10 interrupts
 *      01 ATIME      length of a measurement: 256 − value cycles of 2.4 ms
 *      03 WTIME      the wait, likewise; 0D CONFIG 2: twelve times as long
 *      0F CONTROL    gain 0 … 3: 1, 4, 16, 60
 *      12 ID         44
 *      13 STATUS     1: a measurement is there, 10: interrupt
 *      14 … 1B       clear, red, green, blue of the last measurement, words with their low byte first, at most 65535 and
 *                    1024 for each cycle
 *
 * Source: ams data sheet TCS3472, v1-05, "Register Description" and "Timing". Simplified: no interrupts, the sleep at
 * interrupts neither. The levels are fitted: docs/hardware/colour-sensor.md.
 */
import type { I2cBus, I2cTarget } from '#board/wires/i2c-bus';
import type { Clock } from '#core/clock';
import type { Stop } from '#core/stop';

/** Shares of red, green and blue light. */
export type Light = readonly [red: number, green: number, blue: number];

/** The look of a sensor. */
export interface Look {
  /** The shares that its spot returns, of white paper about 0.85. */
  readonly shares: Light;
  /** The light of its own lamp that reaches there and back, compared with 10 mm above paper. */
  readonly lamp: number;
}

/** One sensor. */
export interface Tcs34725 {
  /** Looks, if it is time. Call it after each step of the world. */
  sample(): void;
  readonly stop: Stop;
}

/** Addresses of the family: 0x29 of most modules, 0x39 of the variant for a second one on the same bus (TCS34721). */
export const TCS34725_ADDRESSES = [0x29, 0x39] as const;

/** Light that reaches the sensor whatever lies before it: of the room, and of the lamp on glossy surfaces. Fitted. */
const STRAY = 0.1;
/** The filters overlap: what each of red, green and blue sees of the light of the three. Fitted. */
const FILTERS: readonly Light[] = [
  [0.9, 0.04, 0.06],
  [0.04, 0.9, 0.06],
  [0.03, 0.09, 0.88],
];
/** Lamp and filters favour green and blue. Fitted. */
const WEIGHTS: Light = [1, 1.3, 1.2];
/** White paper at 10 mm reads 7000 clear with gain 4 and 10 cycles (several owners). */
const PER_CYCLE = 53.204;

const CYCLE_US = 2_400;
const GAINS = [1, 4, 16, 60] as const;
/** Looks within a measurement lie this far apart: chosen, a robot goes 2 mm meanwhile. */
const LOOK_US = 9_600;

const [ENABLE, ATIME, WTIME, CONFIG, CONTROL, ID, STATUS, DATA] = [0x00, 0x01, 0x03, 0x0d, 0x0f, 0x12, 0x13, 0x14];
const REGISTERS = 0x20;

/** The readings clear, red, green, blue of a look, before they are rounded and cut off. */
export function levelsOf({ shares, lamp }: Look, gainTimesCycles = 40): readonly [number, number, number, number] {
  const [red = 0, green = 0, blue = 0] = FILTERS.map(
    (row, i) =>
      PER_CYCLE *
      gainTimesCycles *
      (WEIGHTS[i] ?? 1) *
      (lamp * (row[0] * shares[0] + row[1] * shares[1] + row[2] * shares[2]) + STRAY),
  );
  return [red + green + blue, red, green, blue];
}

/** Puts a sensor on the bus; it measures once it is enabled. */
export function attachTcs34725(clock: Clock, bus: I2cBus, address: number, look: () => Look): Tcs34725 {
  const meter = createMeter(clock, look);
  const stop = bus.attach(address, createTarget(meter));
  return { sample: meter.sample, stop };
}

/** The chip's end of the bus. */
function createTarget({ registers, advance, enable, clear }: Meter): I2cTarget {
  let selected = 0;
  let moves = false;
  const next = (): void => void (selected = moves ? (selected + 1) % REGISTERS : selected);
  return {
    write: ([command, ...data]) => {
      if (command === undefined || command < 0x80) return; // without its highest bit it is no command
      advance();
      if ((command & 0x60) === 0x60) return clear();
      selected = command & 0x1f;
      moves = (command & 0x20) !== 0;
      for (const byte of data) {
        if (selected === ENABLE) enable(byte);
        if (selected < ID) registers[selected] = byte;
        next();
      }
    },
    read: (count) => {
      advance();
      return Uint8Array.from({ length: count }, () => {
        const byte = registers[selected] ?? 0;
        next();
        return byte;
      });
    },
  };
}

/** Measures time after time while it is enabled. */
interface Meter {
  readonly registers: Uint8Array;
  readonly sample: () => void;
  /** Brings the registers up to the present. */
  readonly advance: () => void;
  readonly enable: (bits: number) => void;
  readonly clear: () => void;
}

function createMeter(clock: Clock, look: () => Look): Meter {
  const registers = new Uint8Array(REGISTERS);
  registers.set([0xff], ATIME);
  registers.set([0xff], WTIME);
  registers.set([0x44], ID);
  /** The measurement that goes on; `null`: off. Its light is summed up over its looks. */
  let now: { startUs: number; endUs: number; level: number; most: number; looks: number; sums: number[] } | null = null;
  let lookedUs = -Infinity;

  const begin = (atUs: number): void => {
    const cycles = 256 - (registers[ATIME] ?? 0);
    const startUs = atUs + CYCLE_US; // it gets ready for one cycle
    const level = cycles * (GAINS[(registers[CONTROL] ?? 0) & 3] ?? 1);
    now = { startUs, endUs: startUs + cycles * CYCLE_US, level, most: Math.min(65_535, 1024 * cycles), looks: 0, sums: [0, 0, 0, 0] }; // prettier-ignore
    lookedUs = -Infinity;
  };
  const lookNow = (): void => {
    if (now === null) return;
    lookedUs = clock.nowUs;
    now.looks += 1;
    const levels = levelsOf(look(), now.level);
    now.sums = now.sums.map((sum, i) => sum + (levels[i] ?? 0));
  };
  const finish = ({ looks, sums, most }: NonNullable<typeof now>): void => {
    for (const [i, sum] of sums.entries()) {
      const value = Math.min(Math.round(sum / looks), most);
      registers.set([value & 0xff, value >> 8], DATA + 2 * i);
    }
    registers[STATUS] = 1;
  };
  const waitUs = (): number => {
    if (((registers[ENABLE] ?? 0) & 8) === 0) return 0;
    const long = ((registers[CONFIG] ?? 0) & 2) === 0 ? 1 : 12;
    return (256 - (registers[WTIME] ?? 0)) * CYCLE_US * long;
  };
  const advance = (): void => {
    while (now !== null && clock.nowUs >= now.endUs) {
      if (now.looks === 0) lookNow();
      finish(now);
      begin(now.endUs + waitUs());
    }
  };
  return {
    registers,
    advance,
    sample: () => {
      advance();
      if (now !== null && clock.nowUs >= now.startUs && clock.nowUs - lookedUs >= LOOK_US) lookNow();
    },
    enable: (bits) => {
      const isOn = (bits & 3) === 3;
      if (isOn && now === null) begin(clock.nowUs);
      if (!isOn) now = null;
      if ((bits & 1) === 0) registers[STATUS] = 0;
    },
    clear: () => void (registers[STATUS] = (registers[STATUS] ?? 0) & ~0x10),
  };
}

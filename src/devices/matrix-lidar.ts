/**
 * A matrix lidar DFRobot SEN0628: a laser ranger with 8 × 8 cells over 60° × 60° behind a microcontroller on the I2C bus.
 *
 *      request   55  n high  n low  command  arguments …       n = number of arguments + 1
 *      reply     53 done or 63 failed, command, length low, length high, data …
 *
 * The reply is a stream: any number of reads may take it apart. FF comes until it is ready, after its end, and while there
 * is nothing to say. A new request drops what is left of it. In what follows, words have their low byte first:
 *
 *      command  arguments         data
 *      01       w 0 0 size        none; cells per row: 4 or 8; w is 1 for avoiding obstacles. Settles for 5 s
 *      02       –                 a word per cell, row by row from the upper left: the depth in mm
 *      03       column row        the word of one cell
 *      04, 06   row               the words of a row
 *      05       column            the words of a column
 *      06       –                 way past an obstacle (1 left, 2 right, 3 ahead), 1 if one is nearer than 100 mm,
 *                                 then three words: nearest on the left, ahead, on the right
 *      07       high low          none; the distance in mm from which on an obstacle is passed, 200 at first
 *      08       –                 the three words of 06
 *
 * Sources: DFRobot/DFRobot_MatrixLidar and DFRobot/pxt-DFRobot_matrixLidarDistanceSensor (frames, codes, commands, times to
 * wait), Tiger-Jython/Robotics-Libraries `mbrobot_plusV3.py` (05 and 06 with an argument),
 * jhautbois/maqueen-plus-v3-micropython (n = number of arguments is answered as well, 0 is not). What none of them says is
 * chosen: docs/hardware/matrix-lidar.md.
 */
import type { I2cBus, I2cTarget } from '#board/wires/i2c-bus';
import type { Clock } from '#core/clock';
import type { Stop } from '#core/stop';

/** Cells per row, and rows. */
export type LidarSize = 4 | 8;

/** How modules differ, and where this one is. */
export interface MatrixLidarOptions {
  /** 0x30 … 0x33, by its switches. */
  readonly address: number;
  /** Cells per row after switching on. */
  readonly startSize: LidarSize;
  /** Its word for a cell in which nothing is in range: 4000 with firmware 1.3, 0 with an older one. */
  readonly emptyMm: 4000 | 0;
  /** True if rows and columns have changed places: the module is mounted so, or is thought of so. */
  readonly isTransposed: boolean;
}

/** Depths in mm row by row from the upper left; `Infinity`: nothing is in range. */
export type LidarLook = (size: LidarSize) => readonly number[];

/** One module as its owner sees it. */
export interface MatrixLidar {
  /** Cells per row now. */
  readonly size: () => LidarSize;
  /** For each cell, row by row from the upper left of what it looks at: true if it was read within this time. */
  readonly readWithin: (us: number) => readonly boolean[];
  readonly stop: Stop;
}

/** The farthest and the nearest depth that it gives; nearer things read 0 (a module in a contest robot, at about 30 mm). */
export const LIDAR_RANGE_MM = 4000;
const NEAREST_MM = 20;

const SET_MODE = 0x01;
const START = 0x55;
const DONE = 0x53;
const FAILED = 0x63;
const NOTHING_TO_SAY = 0xff;

/** Its error codes: DFRobot_MatrixLidar. */
const ERROR = { command: 1, packet: 5, argument: 7 } as const;

/** It does not answer at its address before that: DFRobot's wiki advises to wait 3 s after switching on. */
const BOOT_US = 3_000_000;
const SETTLE_US = 5_000_000; // the drivers wait 5 s after a change of mode
/** From a request to its reply: the drivers wait 10 ms and find it, and about 20 ms for all cells. Chosen. */
const READY_US = 9_000;
const ALL_READY_US = 20_000;
/** 60 pictures a second with 4 × 4 cells, 15 with 8 × 8: data sheet. */
const FRAME_US: Readonly<Record<LidarSize, number>> = { 4: 16_667, 8: 66_667 };

const PASSED_FROM_MM = { usual: 200, least: 100, most: 500 } as const; // DFRobot's MakeCode blocks
const CLOSE_MM = 100;
const WAY = { left: 1, right: 2, ahead: 3 } as const;

/** Data of a reply, or the code of an error. */
type Answer = { readonly data: readonly number[]; readonly waitUs?: number } | { readonly error: number };

/** Puts a module on the bus, where it answers once it has started, with the cells of `startSize`. */
export function attachMatrixLidar(
  clock: Clock,
  bus: I2cBus,
  look: LidarLook,
  options: MatrixLidarOptions,
): MatrixLidar {
  const cells = createCells(clock, look, options);
  let leaveBus: Stop = () => undefined;
  const cancelStart = clock.at(clock.nowUs + BOOT_US, () => {
    leaveBus = bus.attach(options.address, createTarget(clock, cells));
  });
  return {
    size: cells.size,
    readWithin: cells.readWithin,
    stop: () => {
      cancelStart();
      leaveBus();
    },
  };
}

/** The module's end of the bus: takes requests apart and gives replies away byte by byte. */
function createTarget(clock: Clock, cells: Cells): I2cTarget {
  const answer = createAnswers(cells);
  let settledUs = 0;
  let reply: { readonly bytes: readonly number[]; readonly readyUs: number } | null = null;
  let taken = 0;
  return {
    write: (bytes) => {
      if (bytes.length === 0) return; // an address probe
      reply = null;
      taken = 0;
      const [start, high = 0, low = 0, command, ...args] = bytes;
      const count = high * 256 + low;
      if (start !== START || command === undefined || count === 0) return;
      const isWhole = count === args.length || count === args.length + 1;
      const said = isWhole ? answer(command, args) : { error: ERROR.packet };
      const [status, data, waitUs = READY_US] =
        'error' in said ? [FAILED, [said.error]] : [DONE, said.data, said.waitUs];
      // Only a change of mode is answered before the cells have settled.
      const readyUs = Math.max(clock.nowUs + waitUs, command === SET_MODE ? 0 : settledUs);
      if (command === SET_MODE && status === DONE) settledUs = clock.nowUs + SETTLE_US;
      reply = { bytes: [status, command, data.length & 0xff, data.length >> 8, ...data], readyUs };
    },
    read: (count) => {
      const bytes = new Uint8Array(count).fill(NOTHING_TO_SAY);
      if (reply === null || clock.nowUs < reply.readyUs) return bytes;
      bytes.set(reply.bytes.slice(taken, taken + count));
      taken += count;
      return bytes;
    },
  };
}

/** Answers requests: a command with its arguments. */
function createAnswers(cells: Cells): (command: number, args: readonly number[]) => Answer {
  let passedFromMm: number = PASSED_FROM_MM.usual;
  const row: Command = ([wanted]) => some(cells.read((_, y) => y === wanted));
  const commands: Readonly<Record<number, Command>> = {
    [SET_MODE]: ([, , , size]) => {
      if (size !== 4 && size !== 8) return { error: ERROR.argument };
      cells.resize(size);
      return { data: [] };
    },
    0x02: () => ({ data: wordsOf(cells.read(() => true)), waitUs: ALL_READY_US }),
    0x03: ([column, row]) => some(cells.read((x, y) => x === column && y === row)),
    0x04: row,
    0x05: ([column]) => some(cells.read((x) => x === column)),
    0x06: (args) => (args.length > 0 ? row(args) : { data: wayPast(cells, passedFromMm) }),
    0x07: ([high = 0, low = 0]) => {
      const wishMm = high * 256 + low;
      if (wishMm < PASSED_FROM_MM.least || wishMm > PASSED_FROM_MM.most) return { error: ERROR.argument };
      passedFromMm = wishMm;
      return { data: [] };
    },
    0x08: () => ({ data: wordsOf(cells.sides().map(cells.word)) }),
  };
  return (command, args) => commands[command]?.(args) ?? { error: ERROR.command };
}

type Command = (args: readonly number[]) => Answer;

/** These words; where the arguments name no cell, an error. */
const some = (words: readonly number[]): Answer =>
  words.length === 0 ? { error: ERROR.argument } : { data: wordsOf(words) };

const wordsOf = (words: readonly number[]): number[] => words.flatMap((word) => [word & 0xff, word >> 8]);

/** The data for avoiding obstacles. Of two sides that are equally free, the left one is recommended: chosen. */
function wayPast(cells: Cells, passedFromMm: number): readonly number[] {
  const [left, ahead, right] = cells.sides();
  const aside = left >= right ? WAY.left : WAY.right;
  const isClose = Math.min(left, ahead, right) < CLOSE_MM;
  return [ahead > passedFromMm ? WAY.ahead : aside, isClose ? 1 : 0, ...wordsOf([left, ahead, right].map(cells.word))];
}

/** The cells of a module, by column from the left and row from the top as it sees them. */
interface Cells {
  readonly size: () => LidarSize;
  resize(size: LidarSize): void;
  /** The words of the wanted cells, row by row. */
  read(isWanted: (column: number, row: number) => boolean): readonly number[];
  /** The least depth in the left quarter of the columns, in the half in the middle, and in the right quarter. */
  sides(): readonly [left: number, ahead: number, right: number];
  /** A depth as it is sent. */
  readonly word: (depthMm: number) => number;
  readonly readWithin: (us: number) => readonly boolean[];
}

function createCells(clock: Clock, look: LidarLook, { startSize, emptyMm, isTransposed }: MatrixLidarOptions): Cells {
  let size = startSize;
  let frame: { readonly depthsMm: readonly number[]; readonly takenUs: number } | null = null;
  let readUs: number[] = [];

  /** The newest picture: a new one, if the last is older than the time between two. */
  const depths = (): readonly number[] => {
    if (frame === null || clock.nowUs - frame.takenUs >= FRAME_US[size]) {
      frame = { depthsMm: look(size), takenUs: clock.nowUs };
    }
    return frame.depthsMm;
  };
  const word = (depthMm: number): number => {
    if (depthMm > LIDAR_RANGE_MM) return emptyMm;
    return depthMm < NEAREST_MM ? 0 : Math.round(depthMm);
  };
  /** The depths of the wanted cells, which thereby are read. */
  const read = (isWanted: (column: number, row: number) => boolean): number[] => {
    const depthsMm = depths();
    const wanted: number[] = [];
    for (let row = 0; row < size; row++) {
      for (let column = 0; column < size; column++) {
        if (!isWanted(column, row)) continue;
        const place = isTransposed ? column * size + row : row * size + column;
        readUs[place] = clock.nowUs;
        wanted.push(depthsMm[place] ?? Infinity);
      }
    }
    return wanted;
  };
  const least = (from: number, to: number): number => Math.min(...read((column) => column >= from && column < to));
  return {
    size: () => size,
    resize: (wish) => {
      size = wish;
      frame = null;
      readUs = [];
    },
    read: (isWanted) => read(isWanted).map(word),
    sides: () => [least(0, size / 4), least(size / 4, (3 * size) / 4), least((3 * size) / 4, size)],
    word,
    readWithin: (us) =>
      Array.from({ length: size * size }, (_, place) => clock.nowUs - (readUs[place] ?? -Infinity) <= us),
  };
}

import { describe, expect, it } from 'vitest';
import { I2cBus } from '#board/wires/i2c-bus';
import { Clock } from '#core/clock';
import { attachMatrixLidar, type LidarLook, type MatrixLidarOptions } from './matrix-lidar';

const AS_DELIVERED: MatrixLidarOptions = { address: 0x33, startSize: 8, emptyMm: 4000, isTransposed: false };

/** Each cell at its own depth: 1000 mm, 100 more per row, 10 more per column. */
const numbered: LidarLook = (size) =>
  Array.from({ length: size * size }, (_, place) => 1000 + 100 * Math.floor(place / size) + 10 * (place % size));

/** All cells of a column at this depth. */
const columns =
  (...depthsMm: number[]): LidarLook =>
  (size) =>
    Array.from({ length: size * size }, (_, place) => depthsMm[place % size]!);

/** A module that has started, and what a program does with it. */
function module(look: LidarLook = numbered, options: Partial<MatrixLidarOptions> = {}) {
  const clock = new Clock();
  const bus = new I2cBus();
  const settings = { ...AS_DELIVERED, ...options };
  const lidar = attachMatrixLidar(clock, bus, look, settings);
  const passMs = (ms: number): void => clock.advanceTo(clock.nowUs + ms * 1000);
  const send = (...bytes: number[]): boolean => bus.write(settings.address, Uint8Array.from(bytes)).acknowledged;
  const take = (count: number): number[] => [...bus.read(settings.address, count).bytes];
  /** The reply to a request, as drivers take it: 4 bytes, then as many as these say, at most 32 at once. */
  const ask = (...request: number[]): number[] => {
    send(...request);
    passMs(20);
    const head = take(4);
    const length = head[2]! + 256 * head[3]!;
    const data: number[] = [];
    while (data.length < length) data.push(...take(Math.min(32, length - data.length)));
    return [...head, ...data];
  };
  passMs(3000);
  return { clock, bus, lidar, passMs, send, take, ask };
}

const word = (value: number): number[] => [value & 0xff, value >> 8];
const row = (y: number, size = 8): number[] =>
  Array.from({ length: size }, (_, x) => word(1000 + 100 * y + 10 * x)).flat();
const column = (x: number, size = 8): number[] =>
  Array.from({ length: size }, (_, y) => word(1000 + 100 * y + 10 * x)).flat();

describe('SEN0628, its requests and replies (DFRobot_MatrixLidar)', () => {
  it('gives one cell as 53 03 02 00 and a word, low byte first: column 3 of row 4', () => {
    const one: LidarLook = () => Array.from({ length: 64 }, (_, place) => (place === 4 * 8 + 3 ? 1234 : 500));
    expect(module(one).ask(0x55, 0, 3, 3, 3, 4)).toEqual([0x53, 3, 2, 0, 0xd2, 0x04]);
  });

  it('gives all 64 cells row by row as 128 bytes, the 16 of 4 × 4 as 32', () => {
    const { ask, passMs } = module();
    expect(ask(0x55, 0, 1, 2)).toEqual([0x53, 2, 0x80, 0, ...[0, 1, 2, 3, 4, 5, 6, 7].flatMap((y) => row(y))]);
    ask(0x55, 0, 5, 1, 0, 0, 0, 4);
    passMs(5000);
    expect(ask(0x55, 0, 1, 2)).toEqual([0x53, 2, 0x20, 0, ...[0, 1, 2, 3].flatMap((y) => row(y, 4))]);
  });

  it('begins with the cells that it was set to: 4 × 4', () => {
    const { ask, lidar } = module(numbered, { startSize: 4 });
    expect(lidar.size()).toBe(4);
    expect(ask(0x55, 0, 2, 5, 3)).toEqual([0x53, 5, 8, 0, ...column(3, 4)]);
  });

  it('gives a column for 5, a row for 6 or 4 with an argument (mbrobot_plusV3)', () => {
    const { ask } = module();
    expect(ask(0x55, 0, 2, 5, 2)).toEqual([0x53, 5, 0x10, 0, ...column(2)]);
    expect(ask(0x55, 0, 2, 6, 7)).toEqual([0x53, 6, 0x10, 0, ...row(7)]);
    expect(ask(0x55, 0, 2, 4, 7)).toEqual([0x53, 4, 0x10, 0, ...row(7)]);
  });

  it('takes the number of arguments as well, as jhautbois/maqueen-plus-v3-micropython sends it, and is silent for 0', () => {
    const { ask } = module();
    expect(ask(0x55, 0, 2, 3, 7, 0)).toEqual([0x53, 3, 2, 0, ...word(1070)]);
    expect(ask(0x55, 0, 0, 2)).toEqual([0xff, 0xff, 0xff, 0xff, ...Array<number>(255 * 257).fill(0xff)]);
  });

  it('says which mistake a request has: 1 no such command, 5 wrong length, 7 no such cell, size or distance', () => {
    const { ask } = module();
    expect(ask(0x55, 0, 1, 9)).toEqual([0x63, 9, 1, 0, 1]);
    expect(ask(0x55, 0, 5, 3, 0, 0)).toEqual([0x63, 3, 1, 0, 5]);
    expect(ask(0x55, 0, 3, 3, 8, 0)).toEqual([0x63, 3, 1, 0, 7]);
    expect(ask(0x55, 0, 2, 5, 8)).toEqual([0x63, 5, 1, 0, 7]);
    expect(ask(0x55, 0, 5, 1, 0, 0, 0, 5)).toEqual([0x63, 1, 1, 0, 7]);
    expect(ask(0x55, 0, 3, 7, 0, 99)).toEqual([0x63, 7, 1, 0, 7]);
  });

  it('does not answer bytes that are no request', () => {
    const { send, take, passMs } = module();
    send(0x54, 0, 1, 2);
    passMs(100);
    expect(take(2)).toEqual([0xff, 0xff]);
    send(0x55, 0);
    passMs(100);
    expect(take(2)).toEqual([0xff, 0xff]);
  });
});

describe('SEN0628, its bytes as a stream', () => {
  it('may be read byte by byte, in any pieces, and gives FF after the last', () => {
    const { send, take, passMs } = module();
    send(0x55, 0, 3, 3, 0, 0);
    passMs(9);
    expect([take(1), take(1), take(2), take(1), take(5)]).toEqual([
      [0x53],
      [3],
      [2, 0],
      [0xe8],
      [3, 255, 255, 255, 255],
    ]);
  });

  it('gives FF until it is ready: 9 ms for a cell, 20 ms for all; nothing is lost by asking early', () => {
    const { send, take, clock } = module();
    const readyAfterMs = (...request: number[]): number => {
      send(...request);
      for (let ms = 0; ; ms++) {
        if (take(1)[0] !== 0xff) return ms;
        clock.advanceTo(clock.nowUs + 1000);
      }
    };
    expect(readyAfterMs(0x55, 0, 3, 3, 0, 0)).toBe(9);
    expect(readyAfterMs(0x55, 0, 1, 2)).toBe(20);
    expect(take(3)).toEqual([2, 0x80, 0]);
  });

  it('drops the rest of a reply when the next request comes, and keeps it over an address probe', () => {
    const { send, take, passMs } = module();
    send(0x55, 0, 1, 2);
    passMs(20);
    take(10);
    send();
    expect(take(2)).toEqual([...word(1030)]);
    send(0x55, 0, 3, 3, 0, 0);
    expect(take(1)).toEqual([0xff]);
    passMs(9);
    expect(take(6)).toEqual([0x53, 3, 2, 0, ...word(1000)]);
  });
});

describe('SEN0628, its times', () => {
  it('does not answer at its address for the first 3 s, and then at the one of its switches', () => {
    const clock = new Clock();
    const bus = new I2cBus();
    const lidar = attachMatrixLidar(clock, bus, numbered, { ...AS_DELIVERED, address: 0x31 });
    clock.advanceTo(2_999_999);
    expect(bus.answers(0x31)).toBe(false);
    clock.advanceTo(3_000_000);
    expect([0x30, 0x31, 0x32, 0x33].filter((address) => bus.answers(address))).toEqual([0x31]);
    lidar.stop();
    expect(bus.answers(0x31)).toBe(false);
  });

  it('answers a change of mode at once with 53 01 00 00, what is asked then when 5 s have passed', () => {
    const { send, take, passMs, lidar } = module();
    send(0x55, 0, 5, 1, 0, 0, 0, 4);
    passMs(9);
    expect(take(5)).toEqual([0x53, 1, 0, 0, 0xff]);
    expect(lidar.size()).toBe(4);
    send(0x55, 0, 3, 3, 3, 3);
    passMs(4990);
    expect(take(1)).toEqual([0xff]);
    passMs(1);
    expect(take(6)).toEqual([0x53, 3, 2, 0, ...word(1330)]);
  });

  it.each([
    [8, 67],
    [4, 17],
  ])('takes a new picture with %i × %i cells when the last one is older than %i ms', (size, periodMs) => {
    let looks = 0;
    const { send, passMs } = module((cells) => Array.from({ length: cells * cells }, () => 100 + ++looks));
    send(0x55, 0, 5, 1, 0, 0, 0, size);
    passMs(6000);
    const point = (): void => void send(0x55, 0, 3, 3, 0, 0);
    point();
    const first = looks;
    passMs(periodMs - 1);
    point();
    expect(looks).toBe(first);
    passMs(1);
    point();
    expect(looks).toBe(first + size * size);
  });
});

describe('SEN0628, its values', () => {
  const at = (depthMm: number, options: Partial<MatrixLidarOptions> = {}): number => {
    const [, , , , low = 0, high = 0] = module(() => Array<number>(64).fill(depthMm), options).ask(0x55, 0, 3, 3, 0, 0);
    return low + 256 * high;
  };

  it('are whole millimetres, 0 below 20, and 4000 or 0 for nothing', () => {
    expect([19.9, 20, 20.5, 3999.4, 4000].map((depth) => at(depth))).toEqual([0, 20, 21, 3999, 4000]);
    expect([at(Infinity), at(4001)]).toEqual([4000, 4000]);
    expect(at(Infinity, { emptyMm: 0 })).toBe(0);
  });

  it('change row and column where the module is transposed', () => {
    const { ask } = module(numbered, { isTransposed: true });
    expect(ask(0x55, 0, 3, 3, 4, 0)).toEqual([0x53, 3, 2, 0, ...word(1400)]);
    expect(ask(0x55, 0, 2, 5, 2)).toEqual([0x53, 5, 0x10, 0, ...row(2)]);
    expect(ask(0x55, 0, 1, 2).slice(4, 20)).toEqual(column(0));
  });

  it('tell which cells were read within the last half second, by their places in the picture', () => {
    const { ask, passMs, lidar } = module(numbered, { isTransposed: true });
    const read = (): number[] => lidar.readWithin(500_000).flatMap((isRead, place) => (isRead ? [place] : []));
    expect(read()).toEqual([]);
    ask(0x55, 0, 3, 3, 4, 0);
    passMs(400);
    ask(0x55, 0, 3, 3, 3, 3);
    expect(read()).toEqual([3 * 8 + 3, 4 * 8]);
    passMs(100);
    expect(read()).toEqual([3 * 8 + 3]);
    ask(0x55, 0, 1, 2);
    expect(read()).toHaveLength(64);
  });
});

describe('SEN0628, avoiding obstacles', () => {
  const ways = [
    ['straight on while it is free', [150, 201, 900, 150], 3, 0],
    ['to the left where that side is freer', [300, 200, 900, 250], 1, 0],
    ['to the right', [250, 900, 150, 300], 2, 0],
    ['to the left where both sides are equal, and warns of something nearer than 100 mm', [99, 120, 120, 99], 1, 1],
  ] as const;

  it.each(ways)('recommends the way %s', (_, depths, way, flag) => {
    const { ask, passMs } = module(columns(...depths));
    ask(0x55, 0, 5, 1, 1, 0, 0, 4);
    passMs(5000);
    const sides = [depths[0], Math.min(depths[1], depths[2]), depths[3]].flatMap(word);
    expect(ask(0x55, 0, 1, 6)).toEqual([0x53, 6, 8, 0, way, flag, ...sides]);
    expect(ask(0x55, 0, 1, 8)).toEqual([0x53, 8, 6, 0, ...sides]);
  });

  it('passes things from another distance on, told high byte first: 300 mm', () => {
    const { ask } = module(columns(500, 500, 250, 250, 250, 250, 400, 400));
    expect(ask(0x55, 0, 1, 6)[4]).toBe(3);
    expect(ask(0x55, 0, 3, 7, 1, 0x2c)).toEqual([0x53, 7, 0, 0]);
    expect(ask(0x55, 0, 1, 6)[4]).toBe(1);
  });

  it('takes a side on which nothing is for the freest, and sends the word for nothing', () => {
    const { ask } = module(columns(300, 300, 100, 100, 100, 100, Infinity, Infinity), { emptyMm: 0 });
    expect(ask(0x55, 0, 1, 6)).toEqual([0x53, 6, 8, 0, 2, 0, ...word(300), ...word(100), 0, 0]);
  });
});

import { describe, expect, it } from 'vitest';
import { I2cBus } from '#board/wires/i2c-bus';
import { Clock } from '#core/clock';
import { createRng } from '#core/rng';
import { attachHuskyLens, frameOf, HUSKYLENS_ADDRESS, type HuskyLook, type HuskyResult } from './huskylens';

const block = (id: number, x: number, y: number): HuskyResult => ({ kind: 'block', x, y, width: 10, height: 20, id });
const arrow: HuskyResult = { kind: 'arrow', tail: [160, 230], head: [300, 20], id: 1 };

/** A camera, and what a program does with it. */
function camera(look: HuskyLook = () => []) {
  const clock = new Clock();
  const bus = new I2cBus();
  let looks = 0;
  const counted: HuskyLook = (algorithm) => {
    looks += 1;
    return look(algorithm);
  };
  const lens = attachHuskyLens(clock, bus, counted, 'tag');
  const write = (...bytes: number[]): void => void bus.write(HUSKYLENS_ADDRESS, Uint8Array.from(bytes));
  const take = (count: number): number[] => [...bus.read(HUSKYLENS_ADDRESS, count).bytes];
  /** All frames of a reply: command and data. */
  const frames = (): number[][] => {
    const got: number[][] = [];
    for (;;) {
      const head = take(5);
      if (head[0] !== 0x55) return got;
      const rest = take(head[3]! + 1);
      expect(frameOf(head[4]!, rest.slice(0, -1))).toEqual([...head, ...rest]);
      got.push([head[4]!, ...rest.slice(0, -1)]);
    }
  };
  const ask = (command: number, ...data: number[]): number[][] => {
    write(...frameOf(command, data));
    return frames();
  };
  const passMs = (ms: number): void => clock.advanceTo(clock.nowUs + ms * 1000);
  return { lens, write, take, frames, ask, passMs, looks: () => looks };
}

describe('HuskyLens', () => {
  it('answers a knock with the bytes of the maker’s description, and 00 after them', () => {
    const { write, take } = camera();
    write(0x55, 0xaa, 0x11, 0x00, 0x2c, 0x3c);
    expect(take(8)).toEqual([0x55, 0xaa, 0x11, 0x00, 0x2e, 0x3e, 0, 0]);
  });

  it('sends a block at (300, 200), 10 × 20, id 1, as the description does', () => {
    const { write, take } = camera(() => [block(1, 300, 200)]);
    write(...frameOf(0x20, []));
    take(16);
    expect(take(16)).toEqual([0x55, 0xaa, 0x11, 0x0a, 0x2a, 0x2c, 1, 0xc8, 0, 0x0a, 0, 0x14, 0, 1, 0, 0x58]);
  });

  it('sends blocks, arrows, both, or those with an id: with their number, the known ids and that of the picture', () => {
    const { ask, passMs } = camera(() => [block(5, 10, 10), block(2, 300, 10), arrow]);
    passMs(100);
    const kinds = (command: number, ...data: number[]): number[] => ask(command, ...data).map(([kind]) => kind!);
    expect(ask(0x20)[0]).toEqual([0x29, 3, 0, 99, 0, 3, 0, 0, 0, 0, 0]);
    expect(kinds(0x20)).toEqual([0x29, 0x2a, 0x2a, 0x2b]);
    expect(kinds(0x21)).toEqual([0x29, 0x2a, 0x2a]);
    expect(kinds(0x22)).toEqual([0x29, 0x2b]);
    expect(kinds(0x23)).toEqual([0x29, 0x2a, 0x2a, 0x2b]);
    expect(ask(0x26, 2, 0)[1]?.slice(9)).toEqual([2, 0]);
    expect(kinds(0x27, 1, 0)).toEqual([0x29]);
    expect(kinds(0x28, 1, 0)).toEqual([0x29, 0x2b]);
  });

  it('changes its algorithm; those of the Pro it declines, and one that is none gets no answer', () => {
    const { ask, lens } = camera();
    for (const [n, algorithm] of ['face', 'track', 'object', 'line', 'colour', 'tag', 'classify'].entries()) {
      expect(ask(0x2d, n, 0)).toEqual([[0x2e]]);
      expect(lens.algorithm()).toBe(algorithm);
    }
    expect([ask(0x2d, 7, 0), ask(0x2d, 8, 0), ask(0x2d, 9, 0)]).toEqual([[[0x3e]], [[0x3e]], []]);
    expect(ask(0x3b)).toEqual([[0x3b, 0, 0]]);
  });

  it('agrees to names, photos, models and texts', () => {
    const { ask } = camera();
    expect(ask(0x2f, 1, 3, 65, 66, 0)).toEqual([[0x2e]]);
    for (const command of [0x30, 0x32, 0x33, 0x34, 0x35, 0x39]) expect(ask(command, 0, 0)).toEqual([[0x2e]]);
  });

  it('forgets, and learns what is in the middle under a number of the program', () => {
    const { ask } = camera(() => [block(5, 10, 10), block(7, 150, 130)]);
    const ids = (): number[] => ask(0x21).slice(1).map((frame) => frame[9]!); // prettier-ignore
    expect(ids()).toEqual([5, 7]);
    ask(0x37);
    expect(ids()).toEqual([0, 0]);
    ask(0x36, 1, 0);
    expect(ids()).toEqual([0, 1]);
    expect(ask(0x24).length).toBe(2);
    expect(ask(0x21)[0]?.slice(3, 5)).toEqual([1, 0]);
  });

  it('does not report colours that it has not learned', () => {
    const { ask } = camera(() => [block(1, 10, 10), block(2, 150, 130)]);
    ask(0x2d, 4, 0);
    ask(0x37);
    expect(ask(0x21).length).toBe(1);
    ask(0x36, 3, 0);
    expect(ask(0x21)[1]?.slice(9)).toEqual([3, 0]);
  });

  it('looks only when it is asked, and once for each of 30 pictures a second', () => {
    const { ask, looks, passMs, lens } = camera(() => [arrow]);
    passMs(1000);
    ask(0x2c);
    expect([looks(), lens.seenWithin(1e9)]).toEqual([0, null]);
    for (let ms = 0; ms < 100; ms += 5) {
      ask(0x20);
      passMs(5);
    }
    expect(looks()).toBe(3);
    expect(lens.seenWithin(100_000)).toEqual([arrow]);
    expect(lens.seenWithin(1000)).toBeNull();
  });

  it('takes a frame byte by byte, skips what begins none, and does not answer a wrong sum or an unknown command', () => {
    const { write, frames } = camera();
    for (const byte of [0x0c, 0x55, 0x55, 0xaa, 0x11, 0x00, 0x2c, 0x3c]) write(byte);
    expect(frames()).toEqual([[0x2e]]);
    write(0x55, 0xaa, 0x11, 0x00, 0x2c, 0x3d);
    expect(frames()).toEqual([]);
    write(...frameOf(0x66, [1, 2, 3]));
    expect(frames()).toEqual([]);
    write();
    write(...frameOf(0x2c, []));
    expect(frames()).toEqual([[0x2e]]);
  });

  it('drops what is left of a reply with the next request', () => {
    const { write, take, frames } = camera(() => [arrow]);
    write(...frameOf(0x20, []));
    take(7);
    write(...frameOf(0x2c, []));
    expect(frames()).toEqual([[0x2e]]);
  });

  it('lives through any bytes: whatever was sent, a knock is answered after as many as the longest frame has', () => {
    const rng = createRng(7);
    const { write, take, ask } = camera(() => [block(1, 10, 10), arrow]);
    for (let round = 0; round < 100; round++) {
      for (let transfer = 0; transfer < 20; transfer++) {
        const noise = Array.from({ length: Math.floor(rng.unit() * 24) }, () => Math.floor(rng.unit() * 256));
        const command = 0x20 + Math.floor(rng.unit() * 0x20);
        const frame = frameOf(command, noise);
        if (rng.unit() < 0.3) frame[Math.floor(rng.unit() * frame.length)] = noise[0] ?? 0;
        write(...(rng.unit() < 0.3 ? noise : rng.unit() < 0.5 ? frame : frame.slice(0, noise.length)));
        expect(take(40).length).toBe(40);
      }
      write(...Array<number>(262).fill(0));
      expect(ask(0x2c)).toEqual([[0x2e]]);
    }
  });
});

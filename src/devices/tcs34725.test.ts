import { describe, expect, it } from 'vitest';

import { I2cBus } from '#board/wires/i2c-bus';
import { Clock } from '#core/clock';

import { attachTcs34725, levelsOf, type Light, type Look } from './tcs34725';

const papers: Readonly<Record<string, Light>> = {
  white: [0.85, 0.85, 0.82],
  gray: [0.4, 0.4, 0.39],
  black: [0.05, 0.05, 0.05],
  red: [0.62, 0.08, 0.08],
  orange: [0.75, 0.3, 0.08],
  yellow: [0.8, 0.68, 0.1],
  green: [0.14, 0.5, 0.14],
  blue: [0.05, 0.2, 0.55],
  purple: [0.35, 0.2, 0.45],
};
const over = (name: string): Look => ({ shares: papers[name] ?? [0, 0, 0], lamp: 1 });

/** Hue in degrees and saturation of 255 · channel / clear, as drivers of strangers see a colour. */
function seen([clear, ...channels]: readonly number[]): { hue: number; saturation: number } {
  const [r = 0, g = 0, b = 0] = channels.map((channel) => (255 * channel) / (clear ?? 1));
  const [most, range] = [Math.max(r, g, b), Math.max(r, g, b) - Math.min(r, g, b)];
  const sixths = most === r ? (g - b) / range : most === g ? 2 + (b - r) / range : 4 + (r - g) / range;
  return { hue: (60 * sixths + 360) % 360, saturation: range / most };
}

describe('the levels of a colour sensor', () => {
  // docs/hardware/colour-sensor.md: hue and saturation that a research robot measured over coloured papers.
  it.each([
    ['red', 0, 0.59],
    ['orange', 40, 0.56],
    ['yellow', 80, 0.68],
    ['green', 120, 0.68],
    ['blue', 209, 0.86],
    ['purple', 260, 0.3],
  ])('over %s have the hue %d° within 18° and the saturation %d within 0.12', (name, hue, saturation) => {
    const is = seen(levelsOf(over(name)));
    expect(Math.abs(((is.hue - hue + 540) % 360) - 180)).toBeLessThanOrEqual(18);
    expect(Math.abs(is.saturation - saturation)).toBeLessThanOrEqual(0.12);
  });

  it('are 7000 clear over white paper at gain 4 and 24 ms, 2018 red, 2623 green, 2359 blue; black is 16 % of it', () => {
    expect(levelsOf(over('white')).map(Math.round)).toEqual([7000, 2018, 2623, 2359]);
    expect(levelsOf(over('black'))[0] / 7000).toBeCloseTo(0.16, 2);
  });

  it('tell white, grey and black apart by clear alone: their hue is the same within 10°', () => {
    const hues = ['white', 'gray', 'black'].map((name) => seen(levelsOf(over(name))).hue);
    expect(Math.max(...hues) - Math.min(...hues)).toBeLessThan(10);
  });
});

/** A sensor over a paper, and a program that talks to it. */
function rig(paper: string) {
  const clock = new Clock();
  const bus = new I2cBus();
  let look = over(paper);
  const chip = attachTcs34725(clock, bus, 0x29, () => look);
  return {
    put: (name: string) => void (look = over(name)),
    write: (...bytes: number[]) => void bus.write(0x29, Uint8Array.from(bytes)),
    read: (count: number) => [...bus.read(0x29, count).bytes],
    /** Steps of the world, each 1 ms. */
    wait(ms: number) {
      for (let i = 0; i < ms; i += 1) {
        clock.advanceTo(clock.nowUs + 1000);
        chip.sample();
      }
    },
    words(register: number): number[] {
      this.write(0xa0 | register);
      const bytes = this.read(8);
      return [0, 2, 4, 6].map((at) => (bytes[at] ?? 0) + 256 * (bytes[at + 1] ?? 0));
    },
  };
}

describe('a TCS34725 on the bus', () => {
  it('has the id 0x44', () => {
    const { write, read } = rig('white');
    write(0x92);
    expect(read(1)).toEqual([0x44]);
  });

  it('has its first value one measurement after it is enabled, not before', () => {
    const it = rig('white');
    it.write(0x81, 0xf6);
    it.write(0x8f, 1);
    it.write(0x80, 0x03);
    it.wait(26);
    it.write(0x93);
    expect([it.read(1), it.words(0x14)]).toEqual([[0], [0, 0, 0, 0]]);
    it.wait(2);
    it.write(0x93);
    expect([it.read(1), it.words(0x14)]).toEqual([[1], [7000, 2018, 2623, 2359]]);
  });

  it('measures nothing while it sleeps', () => {
    const it = rig('white');
    it.wait(1000);
    expect(it.words(0x14)).toEqual([0, 0, 0, 0]);
  });

  it('reads in proportion to gain and length, and at most 1024 for each cycle', () => {
    const read = (atime: number, gain: number): number => {
      const it = rig('white');
      it.write(0x81, atime);
      it.write(0x8f, gain);
      it.write(0x80, 3);
      it.wait(700);
      return it.words(0x14)[0] ?? 0;
    };
    expect([read(0xf6, 0), read(0xf6, 1), read(0xec, 1)]).toEqual([1750, 7000, 14_000]);
    expect([read(0xf6, 3), read(0x00, 3), read(0xff, 3)]).toEqual([10_240, 65_535, 1024]);
  });

  it('gives the mean of what it saw while the robot drove from one paper to another', () => {
    const it = rig('white');
    it.write(0x81, 0xc0);
    it.write(0x80, 3);
    it.wait(80);
    it.put('black');
    it.wait(78);
    const [clear = 0] = it.words(0x14);
    expect(clear / (7000 * (64 / 40))).toBeGreaterThan(0.5);
    expect(clear / (7000 * (64 / 40))).toBeLessThan(0.65);
  });

  it('reads one register again and again without the bit for moving along; without the highest bit it is no command', () => {
    const it = rig('white');
    it.write(0x92);
    expect(it.read(3)).toEqual([0x44, 0x44, 0x44]);
    it.write(0x00, 0x03);
    it.wait(700);
    expect(it.words(0x14)).toEqual([0, 0, 0, 0]);
  });

  it('takes several registers at once, and keeps what it cannot know', () => {
    const it = rig('red');
    it.write(0xa0, 0x03, 0xf6);
    it.write(0xe6);
    it.write(0x81);
    expect(it.read(1)).toEqual([0xf6]);
  });
});

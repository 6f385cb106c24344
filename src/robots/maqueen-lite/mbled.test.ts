import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import type { Rgb } from '#core/rgb';
import { attachWs2812 } from '#devices/ws2812';
import { runOnWires } from '../testing/wires';
import { maqueenLiteBuild } from './robot';

let firmware: WebAssembly.Module;
beforeAll(async () => {
  firmware = await WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));
});

/** Runs a program that has imported everything from mbled, and returns the streams on pin 2. */
function run(program: string) {
  const streams: number[][] = [];
  let colors: readonly Rgb[] = [];
  const result = runOnWires(`from mbled import *\n${program}`, {
    build: maqueenLiteBuild,
    firmware,
    chips: {},
    connect: (board) => {
      const ring = attachWs2812(board.wire('P2'), 24);
      board.wire('P2').onStream((bytes) => {
        streams.push([...bytes]);
        colors = ring.colors();
      });
    },
  });
  return { ...result, streams, colors };
}

describe('mbled: the ring of 24 on pin 2 (Tiger-Jython Robotics-Libraries mbled.py)', () => {
  it('sends nothing when it is imported', () => {
    expect(run('').streams).toEqual([]);
  });

  it('fill(1, 2, 3) sends 24 times green 2, red 1, blue 3', () => {
    const { streams } = run('fill(1, 2, 3)');
    expect(streams).toEqual([Array.from({ length: 24 }, () => [2, 1, 3]).flat()]);
  });

  it('set_led(5, 255, 0, 9) lights the sixth and leaves the others as they are', () => {
    const { colors } = run('fill(1, 1, 1)\nset_led(5, 255, 0, 9)');
    expect(colors[5]).toEqual([255, 0, 9]);
    expect(colors.filter((color) => color.join() === '1,1,1')).toHaveLength(23);
  });

  it('clear() turns all 24 off, at once', () => {
    const { streams, colors } = run('fill(9, 9, 9)\nclear()');
    expect(streams).toHaveLength(2);
    expect(colors.flat().some((part) => part > 0)).toBe(false);
  });

  it('shift_by(1) brings the colour of LED 1 to LED 0 and that of LED 0 round to LED 23', () => {
    const { colors } = run('set_led(0, 100, 0, 0)\nset_led(1, 0, 100, 0)\nshift_by(1)');
    expect(colors[0]).toEqual([0, 100, 0]);
    expect(colors[23]).toEqual([100, 0, 0]);
  });

  it('shift_by(-2) moves it on by two, and 24 steps change nothing', () => {
    const { colors } = run('set_led(0, 100, 0, 0)\nshift_by(-2)\nshift_by(24)');
    expect(colors[2]).toEqual([100, 0, 0]);
  });

  it('lerp_RGB gives the colours in between', () => {
    const { lines } = run(
      [0, 25, 100].map((percent) => `print(lerp_RGB(0, 100, 255, 200, 100, 0, ${percent}))`).join('\n'),
    );
    expect(lines).toEqual(['(0, 100, 255)', '(50, 100, 191)', '(200, 100, 0)']);
  });

  it.each([-1, 101])('lerp_RGB refuses %s percent with a RuntimeError, as the original does', (percent) => {
    expect(run(`lerp_RGB(0, 0, 0, 1, 1, 1, ${percent})`).exception).toMatch(/^RuntimeError: percent/);
  });

  it('has no LED 24', () => {
    expect(run('set_led(24, 1, 1, 1)').exception).toMatch(/^IndexError/);
  });
});

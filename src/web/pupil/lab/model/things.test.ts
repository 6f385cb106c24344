import { describe, expect, it } from 'vitest';

import { defaultScene } from '#scene/scene';
import { soloRun } from '#simulation/run-setup';
import { countOf, firstRange, followed, numberThings, otherThings } from './things';

const run = (text: string) =>
  soloRun({
    ...{ scene: defaultScene(), files: { 'main.py': text }, robot: 'auto', board: 'auto', seed: 1, reality: 0 },
  });
const named = (text: string) => numberThings(run(text)).map(({ name, now }) => [name, now]);

describe('what can vary', () => {
  it('are the numbers of the program, by the names of the command line', () =>
    expect(named('x = -4\n# 7\nmove(1_000, 0x10)\nprint("9", 2j)\n')).toEqual([
      ['main.py:1', -4],
      ['main.py:3.1', 1000],
      ['main.py:3.2', 16],
    ]));

  it('is the start of the robot, how used it is, and chance', () =>
    expect(otherThings(run('')).map(({ name }) => name)).toEqual([
      'start.x',
      'start.y',
      'start.heading',
      'reality',
      'seed',
    ]));

  it.each([
    ['650', { from: 400, to: 900, step: 10 }],
    ['2600', { from: 1500, to: 3500, step: 50 }],
    ['3', { from: 0, to: 8, step: 1 }],
    ['-50', { from: -70, to: -30, step: 1 }],
    ['0.5', { from: 0.3, to: 0.7, step: 0.01 }],
    ['0', { from: 0, to: 10, step: 1 }],
  ])('begins around %s', (text, range) => {
    const [thing] = numberThings(run(`x = ${text}`));
    expect(thing && firstRange(thing)).toEqual({ name: 'main.py:1', ...range });
  });

  it('is the same number after its line has moved or it was written otherwise, and none where that is not sure', () => {
    const then = run('forward()\ndelay(650)\nmove(1, 2)\n');
    const range = { name: 'main.py:2', from: 1, to: 2, step: 1 };
    const nameIn = (text: string, name = range.name) => followed({ ...range, name }, then, run(text))?.name ?? null;
    expect(nameIn('# a\n\nforward()\ndelay(650)\n')).toBe('main.py:4');
    expect(nameIn('delay(300)\nforward()\ndelay(5)\ndelay(650)\n')).toBe('main.py:4');
    expect(nameIn('forward()\nx = 1\nmove(1, 2)\n', 'main.py:3.2')).toBe('main.py:3.2');
    expect(nameIn('forward()\nmove(1, 2)\n', 'main.py:3.2')).toBe('main.py:2.2');
    expect(nameIn('forward()\ndelay(700)\n')).toBe('main.py:2');
    expect(nameIn('forward()\nspeed(700)\ndelay(650)\ndelay(650)\n')).toBeNull();
    expect(nameIn('forward()\n')).toBeNull();
    expect(nameIn('', 'start.x')).toBe('start.x');
  });

  it('has as many values as steps, and none with a step of 0', () => {
    expect(countOf({ name: 'x', from: 400, to: 900, step: 10 })).toBe(51);
    expect(countOf({ name: 'x', from: 1, to: 0, step: 0.1 })).toBe(11);
    expect(countOf({ name: 'x', from: 1, to: 2, step: 0 })).toBe(0);
  });
});

import { describe, expect, it } from 'vitest';
import { defaultScene } from '#scene/scene';
import { soloRun } from '#simulation/run-setup';
import { readSweep, valuesOf, type Sweep } from './sweep';
import { withValues, type Base } from './what';

const MAIN = 'from maqueen import *\nmotor(0, 100)\nsleep(650)\nprint("5")\n';
const base: Base = {
  setup: soloRun({
    ...{ scene: defaultScene(), files: { 'main.py': MAIN, 'turn.py': 'turn = -90\n' } },
    ...{ robot: 'maqueen-lite', board: 'microbit-v2', seed: 1, reality: 0 },
  }),
  usedSeed: 7,
  mainName: 'anna.py',
};

const swept = (...texts: readonly string[]): Sweep => {
  const read = readSweep(texts, base);
  if ('problem' in read) throw new Error(read.problem);
  return read;
};
const setupWith = (text: string, ...values: readonly (number | string)[]) =>
  withValues(base, swept(...text.split(' ')).varied, values);

describe('a sweep', () => {
  it('makes each value of one thing with each of the others, the first slowest', () => {
    const sweep = swept('main.py:3=1,2', 'seed=1..3/1');
    expect(sweep.count).toBe(6);
    expect(Array.from({ length: 6 }, (_, place) => valuesOf(sweep, place))).toEqual([[1, 1], [1, 2], [1, 3], [2, 1], [2, 2], [2, 3]]); // prettier-ignore
  });

  it('writes numbers into any program, two into one line, and calls main.py by its own name, too', () => {
    const { files } = setupWith('main.py:2.2=1 main.py:2.1=1 turn.py:1=1 anna.py:3=1', 50, 12345, 45, 700).devices[0];
    expect(files).toEqual({
      'main.py': MAIN.replace('motor(0, 100)', 'motor(12345, 50)').replace('650', '700'),
      'turn.py': 'turn = 45\n',
    });
  });

  it('moves the start, and chooses options of the robot', () => {
    const { scene, devices } = setupWith('start.x=1 start.heading=1 option.S1=claw', 300, 45, 'claw');
    expect(scene.robot).toMatchObject({ at: [300, base.setup.scene.robot.at[1]], heading: 45 });
    expect(devices[0].robotOptions).toEqual({ S1: 'claw' });
  });

  it('gives a robot that is not ideal the seed of the project', () => {
    expect(setupWith('reality=1', 0.5)).toMatchObject({ reality: 0.5, seed: 7 });
    expect(setupWith('reality=1', 0)).toMatchObject({ reality: 0, seed: 1 });
    expect(setupWith('reality=1 seed=1', 0.5, 9)).toMatchObject({ reality: 0.5, seed: 9 });
  });

  it('gives an ideal robot the seed of an ideal run, also where the project has a used one', () => {
    const used: Base = { ...base, setup: { ...base.setup, seed: 7, reality: 0.5 }, idealSeed: 1 };
    const { varied } = swept('reality=0,0.5');
    expect([0, 0.5].map((value) => withValues(used, varied, [value]).seed)).toEqual([1, 7]);
    expect(withValues(used, swept('start.x=1').varied, [300]).seed).toBe(7);
  });

  it('chooses what a board without a robot is plugged into', () => {
    const bare: Base = { ...base, setup: { ...base.setup, devices: [{ ...base.setup.devices[0], robot: 'none' }] } };
    const read = readSweep(['option.inHand=nothing,gamepad'], bare);
    expect(read).toMatchObject({ count: 2 });
    expect('problem' in read ? null : withValues(bare, read.varied, ['gamepad']).devices[0].robotOptions).toEqual({
      inHand: 'gamepad',
    });
  });

  it.each([
    ['main.py:4=1', 'main.py:4: there is no number in this line: print("5")'],
    ['main.py:5=1', 'main.py:5: there is no number in this line, it is empty.'],
    ['main.py:2=1', 'main.py:2: which of 2 numbers? main.py:2.1 is 0, main.py:2.2 is 100.'],
    ['main.py:2.3=1', 'main.py:2.3: there is no such number in this line: main.py:2.1 is 0'],
    ['main.py:9=1', 'main.py:9: main.py has 5 lines.'],
    ['ben.py:1=1', 'ben.py:1: there is no file "ben.py". There are main.py, turn.py.'],
    ['constructor:1=1', 'constructor:1: there is no file "constructor".'],
    ['speed=1', 'speed: is not known. There are main.py:5'],
    ['main.py:3', '"main.py:3" is not like main.py:5=500..900/50.'],
    ['main.py:3=fast', 'main.py:3: "fast" is neither like'],
    ['seed=1.5', 'seed: 1.5 is not a whole number'],
    ['reality=2', 'reality: 2 is not a number from 0 to 1.'],
    ['option.S9=claw', 'option.S9: Maqueen Lite: there is no option "S9".'],
    ['main.py:3=1 anna.py:3=1', 'anna.py:3: varies already, as main.py:3.'],
    ['main.py:3=1..400#400 seed=1..300/1', 'main.py:3 (400) × seed (300): 120000 runs are too many, at most 100000.'],
  ])('refuses %s', (texts, problem) => {
    const read = readSweep(texts.split(' '), base);
    expect('problem' in read ? read.problem : '').toContain(problem);
  });
});

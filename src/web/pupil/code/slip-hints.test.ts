import { readdirSync, readFileSync } from 'node:fs';

import { describe, expect, it } from 'vitest';

import { contextOf } from '../../session/work/hardware/written-for';
import { slipHints } from './slip-hints';

const context = contextOf({ hardware: null, files: [], file: 'main.py' });
const ALL = 'from microbit import *\nfrom mbrobot import *\n';

/** The hints for a program, and the program after every button was pressed. */
function hintsOf(program: string) {
  const hints = slipHints(program, context);
  const mended = hints
    .flatMap(({ change }) => change ?? [])
    .reduceRight((text, { from, to, insert }) => text.slice(0, from) + insert + text.slice(to), program);
  return { keys: hints.map(({ key }) => key), codes: hints.map(({ values }) => values['code']), mended };
}

describe('the editor tells of', () => {
  it.each([
    [`${ALL}forward`, 'forward()'],
    [`${ALL}display.clear`, 'display.clear()'],
    ['def kreis():\n    pass\nkreis', 'kreis()'],
  ])('a command without brackets in %j', (program, code) => {
    const { keys, codes, mended } = hintsOf(program);
    expect({ keys, codes }).toEqual({ keys: ['error.bareCommand'], codes: [code] });
    expect(mended).toBe(`${program}()`);
  });

  it('a command without its values, which it does not make up', () => {
    const { codes, mended } = hintsOf(`${ALL}setSpeed`);
    expect(codes).toEqual(['setSpeed(…)']);
    expect(mended).toBe(`${ALL}setSpeed`);
  });

  it('a condition that is always true', () => {
    for (const head of ['if', 'while', 'if not'])
      expect(hintsOf(`${ALL}${head} button_a.is_pressed:\n    pass`)).toEqual({
        keys: ['error.bareCondition'],
        codes: ['button_a.is_pressed()'],
        mended: `${ALL}${head} button_a.is_pressed():\n    pass`,
      });
  });

  it('a number with a decimal comma', () => {
    for (const [call, right] of [
      ['leftArc(0,2)', 'leftArc(0.2)'],
      ['delay(1,5)', 'delay(1.5)'],
    ] as const)
      expect(hintsOf(`${ALL}${call}`)).toMatchObject({ keys: ['error.decimalComma'], mended: `${ALL}${right}` });
  });

  it.each([
    ['delay(-2000)', 'error.oddLow'],
    ['sleep(-1)', 'error.oddLow'],
    ['leftArc(-0.2)', 'error.oddLow'],
    ['setSpeed(200)', 'error.oddRange'],
    ['setSpeed(-10)', 'error.oddRange'],
    ['setLED(3)', 'error.oddRange'],
    ['motL.rotate(150)', 'error.oddRange'],
    ['setServo("S1", 270)', 'error.oddRange'],
    ['fillRGB(255, 0, blue=256)', 'error.oddRange'],
  ])('%s, which nobody means', (call, key) => {
    expect(hintsOf(ALL + call)).toMatchObject({ keys: [key], mended: ALL + call });
  });

  it('metres that were meant in cm', () => {
    expect(hintsOf(`${ALL}rightArc(20)`)).toEqual({
      keys: ['error.oddMetres'],
      codes: ['rightArc(0.2)'],
      mended: `${ALL}rightArc(0.2)`,
    });
  });

  it('the limits of the chosen robot', () => {
    const told = (module: string, call: string) => hintsOf(`from ${module} import *\n${call}`).keys;
    expect(told('callibot', 'setSpeed(200)')).toEqual([]);
    expect(told('mbrobot_plus', 'setLED(3)')).toEqual([]);
    expect(told('mbrobot_plusV3', 'setSpeed(101)')).toEqual(['error.oddRange']);
    expect(told('cutebot', 'set_motors_speed(0, -120)')).toEqual(['error.oddRange']);
  });

  it('the loops of TigerJython', () => {
    const { keys, mended } = hintsOf('x = 1\nrepeat 4:\n    repeat 2:\n        print(x)');
    expect(keys).toEqual(['error.repeat']);
    expect(mended).toBe('x = 1\nfor i in range(4):\n    for j in range(2):\n        print(x)');
  });

  it('nothing where a function is meant as a value, or a name is no function', () => {
    for (const program of [
      `${ALL}f = forward`,
      `${ALL}print(forward)`,
      `${ALL}forward()`,
      `${ALL}x = 3\nx`,
      `${ALL}if button_a.is_pressed():\n    pass`,
      `${ALL}Image.HEART`,
      `${ALL}delay(0)\nsetSpeed(100)\nleftArc(1)\nsetLED(1, 0)\nsetSpeed(x)\ndelay()`,
      'unbekannt',
      '# repeat 4:\nrepeat = 3',
    ] as const)
      expect(hintsOf(program).keys).toEqual([]);
  });

  it('nothing in the programs that come with Parcours', () => {
    const programs = ['courses', 'src/robots', 'examples'].flatMap((folder) =>
      readdirSync(folder, { recursive: true, encoding: 'utf8' })
        .filter((name) => name.endsWith('.py') && !name.includes('library'))
        .map((name) => `${folder}/${name}`),
    );
    expect(programs.length).toBeGreaterThan(30);
    const told = programs.filter((path) => hintsOf(readFileSync(path, 'utf8')).keys.length > 0);
    expect(told).toEqual([]);
  });
});

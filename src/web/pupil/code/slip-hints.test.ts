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
      'unbekannt',
      '# repeat 4:\nrepeat = 3',
    ])
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

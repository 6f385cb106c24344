import { describe, expect, it } from 'vitest';

import { calliopeMini3 } from '#board/boards/calliope-mini-3';
import { microbitV2 } from '#board/boards/microbit-v2';
import { findRobot } from '#robots/index';
import type { Hardware } from '#simulation/hardware';
import { play } from '#vm/library/testing/play';
import { lastPlace } from '../log/console-log';
import { lateAdvice, type LateAdvice } from './late-advice';

const bare = { hardware: null, files: [], file: 'main.py' } as const;
const on = (board: Hardware['board'], robot: unknown = null) => ({
  ...bare,
  hardware: { board, firmware: null, robot } as unknown as Hardware,
});

/** Runs a program on our VM and gives what is found out about its error. */
function lateOf(program: string, written: Parameters<typeof lateAdvice>[2] = bare): LateAdvice {
  const exception = play(program).until(3_000).ended()?.exception;
  if (exception === null || exception === undefined) throw new Error(`No error in: ${program}`);
  const line = lastPlace(exception.traceback, ['main.py'])?.line ?? 1;
  return lateAdvice(exception, { text: program, line }, written);
}

const ALL = 'from microbit import *\n';

describe('a forgotten import', () => {
  it.each([
    ['display.show("A")', 'from microbit import *'],
    ['sleep(100)', 'from microbit import *'],
    ['button_a.is_pressed()', 'from microbit import *'],
    ['music.play(music.ODE)', 'import music'],
    ['radio.on()', 'import radio'],
    ['x = randint(1, 6)', 'from random import randint'],
  ])('of %j is %j', (program, code) => {
    const { advice, mend } = lateOf(program);
    expect(advice?.key).toBe('error.forgottenImport');
    expect(advice?.values['code']).toBe(code);
    expect(mend?.after).toBe(`${code}\n${program}`);
    expect(mend?.adds).toBe(true);
  });

  it('is the one of the chosen board and robot', () => {
    expect(lateOf('forward()', on(microbitV2, findRobot('maqueen-lite'))).mend?.code).toBe('from mbrobot import *');
    expect(lateOf('display.show("A")', on(calliopeMini3)).mend?.code).toBe('from calliopemini import *');
    expect(lateOf('forward()', on(microbitV2)).advice).toBeNull();
  });

  it('comes after a first comment and text, and after the other imports', () => {
    expect(lateOf('# Ich\n"""Doc"""\nimport math\n\ndisplay.show("A")').mend?.after).toBe(
      '# Ich\n"""Doc"""\nimport math\nfrom microbit import *\n\ndisplay.show("A")',
    );
    expect(lateOf('# Ich\n"""Doc"""\nsleep(1)').mend?.after).toBe('# Ich\n"""Doc"""\nfrom microbit import *\nsleep(1)');
    expect(lateOf('# Ich\nsleep(1)').mend?.after).toBe('# Ich\nfrom microbit import *\nsleep(1)');
  });

  it('does not win over single names that are imported', () => {
    expect(lateOf('from time import sleep\ndisplay.show("A")').mend?.after).toBe(
      'from microbit import *\nfrom time import sleep\ndisplay.show("A")',
    );
  });

  it('is the name before the dot where the module is there', () => {
    const { advice, mend } = lateOf('import random\nx = randint(1, 6)');
    expect(advice?.key).toBe('error.forgottenOwner');
    expect(mend?.after).toBe('import random\nx = random.randint(1, 6)');
    expect(lateOf('import microbit as mb\ndisplay.show("A")').mend?.code).toBe('mb.display.show("A")');
  });

  it('is not guessed where the program uses the name itself, or the name is unknown', () => {
    expect(lateOf('print(temperature)\ndef f(temperature):\n    pass').advice?.key).not.toBe('error.forgottenImport');
    expect(lateOf('sleep(1)\nsleep = 3').advice?.key).toBe('error.definedLater');
    expect(lateOf('print(irLinks)').advice).toBeNull();
  });

  it('mends the program', () => {
    const { mend } = lateOf('display.show("A")');
    expect(
      play(mend?.after ?? 'x')
        .until(3_000)
        .ended()?.exception,
    ).toBeNull();
  });
});

describe('a name that the program has elsewhere', () => {
  it('is told to come earlier', () => {
    expect(lateOf('f()\ndef f():\n    pass').advice?.values).toEqual({ name: 'f', line: 2 });
    expect(lateOf('print(zahl)\nzahl = 3').advice?.key).toBe('error.definedLater');
  });

  it('is told to live inside its function', () => {
    expect(lateOf('def f():\n    y = 1\nf()\nprint(y)').advice?.key).toBe('error.onlyInside');
  });
});

describe('a call with the wrong number of values', () => {
  it.each([
    [`${ALL}display.set_pixel(1, 2)`, 'display.set_pixel(x, y, value)'],
    [`${ALL}sleep(1, 5)`, 'sleep(ms)'],
    ['def f(a, b=2):\n    return a\nf()', 'f(a, b=2)'],
    ['x = [1]\nx.append(1, 2)', 'x.append(value)'],
    ['def f(a, b=2):\n    return a\nprint(f(), abs(-1))', 'f(a, b=2)'],
  ])('in %j says what goes into the brackets', (program, code) => {
    expect(lateOf(program).advice).toEqual({ key: 'error.wantsThis', values: { code } });
  });

  it('says for an arc what the number means, with an example', () => {
    const failure = { type: 'TypeError', message: 'function takes 1 positional arguments but 0 were given' };
    const source = { text: 'from mbrobot import *\nleftArc()', line: 2 };
    expect(lateAdvice(failure, source, bare).advice).toEqual({
      key: 'error.wantsMetres',
      values: { code: 'leftArc(0.2)' },
    });
  });

  it('says where nothing goes into them', () => {
    expect(lateOf(`${ALL}button_a.is_pressed(1)`).advice).toEqual({
      key: 'error.wantsNothing',
      values: { name: 'button_a.is_pressed' },
    });
    expect(lateOf('def f():\n    return 1\nf(1)').advice?.key).toBe('error.wantsNothing');
  });
});

describe('a decimal comma', () => {
  const decimals = 'def bogen(radius):\n    pass\ndef punkt(x, y):\n    pass\n';
  it.each([
    [`${ALL}sleep(1,5)`, '1.5', 'sleep(1.5)'],
    [`${decimals}bogen(0,2)`, '0.2', 'bogen(0.2)'],
    [`${decimals}bogen(-0,25)  # links`, '-0.25', 'bogen(-0.25)  # links'],
    [`${decimals}punkt(1,5, 2,5)`, '1.5', 'punkt(1.5, 2.5)'],
  ])('in %j becomes a point', (program, code, line) => {
    const { advice, mend } = lateOf(program);
    expect(advice).toMatchObject({ key: 'error.decimalComma', values: { code } });
    expect(mend?.after.split('\n').at(-1)).toBe(line);
  });

  it('is not seen where the values may be meant one by one', () => {
    for (const call of ['bogen(1, 5)', 'bogen(1,5,2)', 'punkt(1,2,3)'])
      expect(lateOf(decimals + call).advice?.key).toBe('error.wantsThis');
  });
});

describe('a method without self', () => {
  it('is told so', () => {
    const program = 'class Hund:\n    def bell():\n        pass\nh = Hund()\nh.bell()';
    expect(lateOf(program).advice).toEqual({ key: 'error.selfMissing', values: { name: 'bell' } });
  });
});

describe('a name that is nearly right', () => {
  it('is written right by the button', () => {
    const { meant, mend } = lateOf(`${ALL}display.sow("a")`);
    expect(meant).toBe('show');
    expect(mend).toMatchObject({ code: 'show', after: `${ALL}display.show("a")` });
    expect(lateOf('import Math').mend?.after).toBe('import math');
  });

  it('is asked for without the advice to look for it', () => {
    expect(lateOf('anzahl = 3\nprint(anzhal)').advice).toEqual({
      key: 'error.unknownName',
      values: { name: 'anzhal' },
    });
    expect(lateOf('print(irLinks)').advice).toBeNull();
  });
});

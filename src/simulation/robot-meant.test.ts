import { describe, expect, it } from 'vitest';

import { importsOf } from '#python/imports';
import { findRobot } from '#robots/index';
import { robotMeant } from './robot-fit';

const named = (id: string | null) => (id === null ? null : findRobot(id));
const meant = (program: string, chosen: string | null, more: Readonly<Record<string, string>> = {}) =>
  robotMeant(importsOf({ 'main.py': program, ...more }), named(chosen))?.id ?? null;

describe('the robot that a program is for', () => {
  it('is told where another one is chosen, on another board or on the same', () => {
    expect(meant('from mbrobot import *\nforward()', 'callibot')).toBe('maqueen-lite');
    expect(meant('from mbrobot import *\nforward()', 'maqueen-plus-v2')).toBe('maqueen-lite');
    expect(meant('import callibotmot', 'maqueen-lite')).toBe('callibot');
  });

  it('is told too where a second file imports its module', () => {
    expect(meant('import drive', 'callibot', { 'drive.py': 'from mbrobot_plusV2 import *' })).toBe('maqueen-plus-v2');
  });

  it('is the one that is chosen, as soon as one module is its own', () => {
    expect(meant('from mbrobot import *', 'maqueen-lite')).toBeNull();
    expect(meant('from mbrobot import *\nimport callibot', 'callibot')).toBeNull();
  });

  it('cannot be told from programs for every robot or for the board alone', () => {
    expect(meant('from simrobot import *', 'callibot')).toBeNull();
    expect(meant('from microbit import *', 'maqueen-lite')).toBeNull();
  });

  it('cannot be told either where the module is a file of the pupil', () => {
    expect(meant('from mbrobot import *', 'callibot', { 'mbrobot.py': 'def forward(): pass' })).toBeNull();
  });

  it('is told by a driver of others too, which lies beside the program, unless it has one for the chosen robot', () => {
    const driver = (name: string) => ({ [`${name}.py`]: 'def go(): pass' });
    expect(meant('import maqueenPlusV2', 'callibot', driver('maqueenPlusV2'))).toBe('maqueen-plus-v2');
    expect(meant('import maqueenPlusV2', 'maqueen-plus-v2', driver('maqueenPlusV2'))).toBeNull();
    expect(meant('from mbrobot import *\nimport maqueenplusv2', 'maqueen-lite', driver('maqueenplusv2'))).toBeNull();
  });

  it('is told where no robot is chosen at all', () => {
    expect(meant('from mbrobot import *', null)).toBe('maqueen-lite');
  });
});

import { describe, expect, it } from 'vitest';

import { foreignModules } from '#python/imports';
import { findRobot } from '#robots/index';
import { robotMeant } from './hardware';

const named = (id: string | null) => (id === null ? null : findRobot(id));
const meant = (program: string, chosen: string | null, more: Readonly<Record<string, string>> = {}) =>
  robotMeant(foreignModules({ 'main.py': program, ...more }), named(chosen))?.id ?? null;

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

  it('is told where no robot is chosen at all', () => {
    expect(meant('from mbrobot import *', null)).toBe('maqueen-lite');
  });
});

import { describe, expect, it } from 'vitest';

import { modulesImportedBy } from '#python/imports';
import { defaultScene } from '#scene/scene';
import { AUTO, chooseHardware } from './hardware';

/** The robot for a program that imports a driver by others, when no robot was chosen. */
function robotFor(module: string): string | null {
  const files = { 'main.py': `from microbit import *\nimport ${module}`, [`${module}.py`]: '' };
  const hardware = chooseHardware({
    scene: defaultScene(),
    imports: modulesImportedBy(files),
    robot: AUTO,
    board: AUTO,
  });
  return 'problem' in hardware ? hardware.problem : (hardware.robot?.id ?? null);
}

describe('the robot for a driver that somebody else wrote', () => {
  it('is the Maqueen Plus V2 for its usual names, with or without underscores and capitals', () => {
    for (const name of ['maqueenplusv2', 'maqueenplus_v2', 'maqueen_plus_v2', 'maqueenPlusV2'])
      expect([name, robotFor(name)]).toEqual([name, 'maqueen-plus-v2']);
  });

  it('is the Maqueen Plus V1 for maqueenplus (lawther) and Maqueen_Plus (Koraze), the V2 for maqueen_plus (almasy)', () => {
    expect(['maqueenplus', 'Maqueen_Plus', 'maqueen_plus'].map(robotFor)).toEqual([
      'maqueen-plus-v1',
      'maqueen-plus-v1',
      'maqueen-plus-v2',
    ]);
  });

  it('is the Maqueen Lite for maqueen, whatever its capitals', () => {
    expect(['maqueen', 'Maqueen', 'maqueen_lite'].map(robotFor)).toEqual(Array(3).fill('maqueen-lite'));
  });

  it('is the MotionKit 2 for MotionKitV2 (the Calliope editor), motionkit (tinysuperlab) and mklib (chbijou)', () => {
    expect(['MotionKitV2', 'motionkit', 'mklib'].map(robotFor)).toEqual(Array(3).fill('motionkit-2'));
  });

  it('is the Cutebot for cutebot (Vittascience) and Cutebot (Elecfreaks)', () => {
    expect(['cutebot', 'Cutebot'].map(robotFor)).toEqual(Array(2).fill('cutebot'));
  });
});

import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import { modulesImportedBy } from '#python/imports';
import { defaultScene } from '#scene/scene';
import { chooseHardware, hardwareIds } from './hardware';
import { soloRun } from './run-setup';
import { Simulation } from './simulation';

let firmware: WebAssembly.Module;
beforeAll(async () => {
  firmware = await WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));
});

async function start(...lines: string[]): Promise<Simulation> {
  const files = { 'main.py': lines.join('\n') };
  const scene = defaultScene();
  const hardware = chooseHardware({ scene, imports: modulesImportedBy(files), robot: 'auto', board: 'auto' });
  if ('problem' in hardware) throw new Error(hardware.problem);
  return Simulation.create(soloRun({ scene, files, ...hardwareIds(hardware), seed: 1, reality: 0 }), firmware);
}

describe('chains of lights in a run', { timeout: 30_000 }, () => {
  it('show as 24 lights on P2 once mbled fills its ring, while the robot drives, and not before', async () => {
    const run = await start(
      'from mbrobot import *',
      'from mbled import *',
      'forward()',
      'delay(500)',
      'fill(0, 20, 0)',
      'fillRGB(1, 2, 3)',
    );
    run.advanceTo(400_000);
    expect(run.snapshot().lights).toEqual([]);
    run.advanceTo(1_000_000);
    const { lights, robot } = run.snapshot();
    expect(lights.map(({ pin, colors }) => [pin, colors.length, colors[7]])).toEqual([['P2', 24, [0, 20, 0]]]);
    expect(robot?.pathMm).toBeGreaterThan(50);
    expect(robot?.state.rgb).toEqual(Array(4).fill([1, 2, 3]));
  });

  it('choose no robot: mbled beside mbrobot_plusV2 lies on a Plus V2', async () => {
    const run = await start('from mbled import *', 'from mbrobot_plusV2 import *', 'fill(1, 1, 1)');
    run.advanceTo(500_000);
    expect(run.snapshot().robot?.type).toBe('maqueen-plus-v2');
    expect(run.snapshot().lights[0]?.colors).toHaveLength(24);
  });

  it('are found on two pins of a Calliope mini, its own three lights apart', async () => {
    const run = await start(
      'from calliopemini import *',
      'from neopixel import NeoPixel',
      'for pin, n in ((pin0, 256), (pin2, 8), (pin_RGB, 3)):',
      '    lights = NeoPixel(pin, n)',
      '    lights[0] = (1, 2, 3)',
      '    lights.show()',
    );
    run.advanceTo(500_000);
    expect(run.snapshot().lights.map(({ pin, colors }) => [pin, colors.length])).toEqual([
      ['P0', 256],
      ['P2', 8],
    ]);
    expect(run.snapshot().rgb[0]).toEqual([1, 2, 3]);
  });
});

// @vitest-environment happy-dom
import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';

import { robotTypes } from '#robots/index';
import type { RobotType } from '#robots/robot';
import { chooseHardware, hardwareIds } from '#simulation/hardware';
import { soloRun } from '#simulation/run-setup';
import { Simulation } from '#simulation/simulation';
import { defaultScene, type Scene } from '#scene/scene';

import '../../app/testing/mount-on';
import { createNarrator } from './narrator';

/** A line a little to the left of the robot's middle, and a wall ahead. */
const scene: Scene = {
  ...defaultScene(),
  robot: { ...defaultScene().robot, at: [200, 450] },
  objects: [
    { type: 'stroke', id: 'line', points: [[0, 462], [900, 462]], width: 20, color: 'black' }, // prettier-ignore
    { type: 'wall', id: 'wall', from: [600, 0], to: [600, 900], thickness: 10 },
  ],
};

let firmware: WebAssembly.Module;
beforeAll(async () => {
  firmware = await WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));
});

/** The announcement of a robot at its start, as its own run shows it. */
async function startOf({ id, body }: RobotType): Promise<string> {
  const hardware = chooseHardware({ scene, imports: new Set(), robot: id, board: 'auto' });
  if ('problem' in hardware) throw new Error(hardware.problem);
  const files = { 'main.py': '' };
  const run = await Simulation.create(
    soloRun({ scene, files, ...hardwareIds(hardware), seed: 1, reality: 0 }),
    firmware,
  );
  run.advanceTo(300_000);
  const narrator = createNarrator(() => ({ scene, body: body.outlineMm }));
  narrator.see(run.snapshot(), 0);
  return narrator.next(0) ?? '';
}

/** The line in the words for its sensors. */
const onLine: Readonly<Record<string, string>> = {
  'maqueen-lite': 'Linker Sensor auf der Linie.',
  'maqueen-plus-v1': 'Auf der Linie: L2, L1.',
  'maqueen-plus-v2': 'Auf der Linie: L1.',
  'maqueen-plus-v3': 'Auf der Linie: L1.',
  callibot: 'Linker Sensor auf der Linie.',
};

describe('the telling of a drive', { timeout: 30_000 }, () => {
  it.each(robotTypes)('knows the sensors of $name', async (type) => {
    const words = await startOf(type);
    expect(words).toMatch(/^Start bei x 20, y 45 cm, Richtung 0 Grad\. Wand 3\d cm voraus\./);
    expect(words).toContain(onLine[type.id] ?? 'auf der Linie');
  });
});

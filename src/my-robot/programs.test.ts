import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import { robotTypes } from '#robots/index';
import { defaultScene } from '#scene/scene';
import { soloRun } from '#simulation/run-setup';
import { Simulation } from '#simulation/simulation';
import { DRIVES } from './my-robot';
import { predictMotion } from './predict';
import { programOf } from './programs';

let firmware: WebAssembly.Module;
beforeAll(() => {
  firmware = new WebAssembly.Module(readFileSync('.cache/vm/vm.wasm'));
});

describe.each(robotTypes)('the programs that measure a $name', { timeout: 30_000 }, (type) => {
  it('drive it straight on three times, and turn it', async () => {
    const { drives, turnDeg } = await predictMotion({ type, firmware });
    for (const name of DRIVES) expect(drives[name].aheadMm, name).toBeGreaterThan(50);
    expect(turnDeg).not.toBe(0);
  });

  it('print the distance to a wall at a press of button A, in cm', async () => {
    const press = (ms: number, down: boolean) =>
      ({ timeUs: ms * 1000, action: { type: 'button', button: 'a', down } }) as const;
    const scene = { ...defaultScene(), robot: { ...defaultScene().robot, type: type.id } };
    const files = { 'main.py': programOf('distance', type).en };
    const hardware = { robot: type.id, board: type.board, seed: 1, reality: 0 };
    const inputs = [press(4000, true), press(4050, false)]; // a lidar takes 3 s to start
    const run = await Simulation.create(soloRun({ scene, files, ...hardware, inputs }), firmware);
    run.advanceTo(8_000_000);
    expect(run.ended?.exception ?? null).toBeNull();
    expect(Number(run.takeConsole())).toBeGreaterThan(10);
  });
});

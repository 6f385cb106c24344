import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';

import { boardTypes } from '#board/boards/index';
import { robotTypes } from '#robots/index';
import { defaultScene } from '#scene/scene';
import { soloRun } from '#simulation/run-setup';
import { Simulation } from '#simulation/simulation';
import type { Snapshot } from '#simulation/snapshot';

import { readingsOf } from './readings';

let firmware: WebAssembly.Module;
beforeAll(async () => {
  firmware = await WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));
});

const files = { 'main.py': 'from microbit import *\nimport music\nmusic.pitch(440, wait=False)\nsleep(1000)\n' };

async function momentOf(robot: string, board: string): Promise<Snapshot> {
  const setup = soloRun({ scene: defaultScene(), files, robot, board, seed: 1, reality: 0 });
  const simulation = await Simulation.create(setup, firmware);
  simulation.advanceTo(500_000);
  return simulation.snapshot();
}

/** The value at a path in a snapshot. */
const at = (moment: Snapshot, path: readonly (string | number)[]): unknown =>
  path.reduce<unknown>((whole, key) => (whole as Readonly<Record<string, unknown>> | null)?.[key], moment);

const kinds = [
  ...robotTypes.map(({ id }) => ({ robot: id, board: 'auto' })),
  ...boardTypes.map(({ id }) => ({ robot: 'none', board: id })),
];

describe.each(kinds)('the curves of $robot on board $board', ({ robot, board }) => {
  it('each draw something that a snapshot has', async () => {
    const moment = await momentOf(robot, board);
    const type = robotTypes.find(({ id }) => id === robot);
    const readings = readingsOf(moment, type);
    expect(readings.length).toBeGreaterThan(type ? 20 : 10);
    const empty = readings.filter(({ paths }) => paths.some((path) => at(moment, path) === undefined));
    expect(empty.map(({ id }) => id)).toEqual([]);
  });

  it('of colour lights give the brightest of three colours in per cent', async () => {
    const lights = readingsOf(await momentOf(robot, board), undefined).filter(({ paths }) => paths.length === 3);
    for (const light of lights) expect(light.value([51, 255, 0])).toBe(100);
  });
});

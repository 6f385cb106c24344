import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';

import { boardTypes } from '#board/boards/index';
import { robotTypes } from '#robots/index';
import type { LidarState } from '#robots/robot';
import { lidarOf } from '#robots/testing/lidar-of';
import { defaultScene } from '#scene/scene';
import { soloRun } from '#simulation/run-setup';
import { Simulation } from '#simulation/simulation';
import type { Snapshot } from '#simulation/snapshot';
import type { Leaf } from '#tape/rows/leaves';

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

describe('the curves of a lidar', () => {
  /** The values of the curves of a robot that sees this. */
  async function valuesOf(seen: LidarState): Promise<Record<string, number | null>> {
    const moment = await momentOf('maqueen-lite', 'auto');
    const device = { ...moment, robot: moment.robot && { ...moment.robot, state: { ...moment.robot.state, lidar: seen } } }; // prettier-ignore
    const readings = readingsOf(device, robotTypes[0]);
    const shown = readings.filter(({ name }) => name.startsWith('Lidar'));
    return Object.fromEntries(
      shown.map((reading) => [reading.name, reading.value(reading.paths.map((path) => at(device, path) as Leaf))]),
    );
  }

  it('are two: the nearest at eye level, and that of the four middle cells', async () => {
    const row = [420, 440, null, 460, 470, 320, 230, 180];
    expect(await valuesOf(lidarOf({ row }))).toEqual({ Lidar: 18, 'Lidar, Mitte': 46 });
  });

  it('go on when the program changes to 4 × 4 cells', async () => {
    expect(await valuesOf(lidarOf({ row: [400, 350, 360, 300], size: 4 }))).toEqual({ Lidar: 30, 'Lidar, Mitte': 35 });
  });

  it('have no value where nothing is in range', async () => {
    const row = [null, null, null, null, null, null, null, null];
    expect(await valuesOf(lidarOf({ row }))).toEqual({ Lidar: null, 'Lidar, Mitte': null });
  });
});

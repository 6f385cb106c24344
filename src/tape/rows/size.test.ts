import { describe, expect, it } from 'vitest';
import { Simulation } from '#simulation/simulation';
import type { RunSetup } from '#simulation/run-setup';
import type { Snapshot } from '#simulation/snapshot';
import { convoyOf } from '#simulation/testing/convoy';
import { courseRun } from '#simulation/testing/course-run';
import { readFileSync } from 'node:fs';
import { RowWriter } from './row-writer';
import { Rows } from './rows';

const firmware = await WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));

const PERIOD_US = 20_000;

/** A run's snapshots every 20 ms, and the tape of it. */
async function taped(setup: RunSetup, seconds: number): Promise<{ rows: Rows<Snapshot>; last: Snapshot }> {
  const simulation = await Simulation.create(setup, firmware);
  const [writer, rows] = [new RowWriter(), new Rows<Snapshot>()];
  for (let us = PERIOD_US; us <= seconds * 1_000_000; us += PERIOD_US) {
    simulation.advanceTo(us);
    const piece = writer.add(simulation.snapshot());
    if (piece) rows.push(piece);
  }
  const piece = writer.finish();
  if (piece) rows.push(piece);
  return { rows, last: simulation.snapshot() };
}

/** Drives on and on in an empty arena, past walls that its 64 cells see. */
const LIDAR_PROGRAM = `from mbrobot_plusV3 import *
sleep(3500)
setSpeed(60)
while True:
    if getDistance() < 25:
        left()
        sleep(300)
    else:
        forward()
    sleep(50)
`;
const lidarRun: RunSetup = { ...courseRun('empty', 1), devices: [{ name: '1', files: { 'main.py': LIDAR_PROGRAM }, robot: 'maqueen-plus-v3', board: 'auto' }] }; // prettier-ignore

describe('what a run shows, 50 times a second,', () => {
  it.each([
    ['a line follower', courseRun('closed-line', 1), 1],
    ['a robot that pushes blocks', courseRun('clear-the-ring', 1), 1],
    ['a robot with a lidar that drives about', lidarRun, 1],
    ['four devices that talk, drive and push', convoyOf(4), 4],
  ])('takes less than 1 MB for ten minutes and device: %s', async (_, setup, devices) => {
    const { rows, last } = await taped(setup, 20);
    const bytesInTenMinutes = (rows.bytes * 30) / devices;
    expect(bytesInTenMinutes).toBeLessThan(1_000_000);
    const shown = rows.at(Infinity);
    expect(shown).toMatchObject({ timeUs: last.timeUs, running: last.running, display: last.display });
    expect(shown?.robot?.pose.xMm ?? 0).toBeCloseTo(last.robot?.pose.xMm ?? 0, 0);
    expect(shown?.others.length).toBe(devices - 1);
  });
});

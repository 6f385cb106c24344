import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';

import { defaultScene } from '#scene/scene';
import { soloRun } from '#simulation/run-setup';
import { Simulation } from '#simulation/simulation';
import type { Snapshot } from '#simulation/snapshot';
import type { Chunk } from '#tape/rows/chunk';
import { Rows } from '#tape/rows/rows';
import { RowWriter } from '#tape/rows/row-writer';
import { momentAt } from './trail-moment';

const firmware = await WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));

/** The tape of a robot that drives, and where it was every 20 ms. */
async function drive(main: string, untilUs: number) {
  const writer = new RowWriter();
  const seen: { readonly timeUs: number; readonly x: number; readonly y: number }[] = [];
  const rows = new Rows<Snapshot>();
  const chunks: Chunk[] = [];
  const take = (piece: Uint8Array | null): void => {
    const chunk = piece === null ? null : rows.push(piece);
    if (chunk !== null) chunks.push(chunk);
  };
  const note = (snapshot: Snapshot): void => {
    const { xMm, yMm } = snapshot.robot!.pose;
    seen.push({ timeUs: snapshot.timeUs, x: xMm, y: yMm });
    take(writer.add(snapshot));
  };
  const setup = soloRun({
    scene: defaultScene(),
    files: { 'main.py': main },
    ...{ robot: 'maqueen-lite', board: 'microbit-v2', seed: 1, reality: 0 },
  });
  const run = await Simulation.create(setup, firmware, { moment: note });
  run.advanceTo(untilUs);
  take(writer.finish());
  return { chunks, seen };
}

describe('when the robot was at a place of its trail', { timeout: 30_000 }, () => {
  const reachMm = 8;

  it('is the time of the nearest of its places', async () => {
    const { chunks, seen } = await drive('from mbrobot import *\nsetSpeed(30)\nforward()\ndelay(9000)', 8_000_000);
    expect(chunks.length).toBeGreaterThan(1);
    for (const { timeUs, x, y } of [seen[30]!, seen[60]!, seen[90]!]) {
      const found = momentAt(chunks, { device: 0, at: { x, y: y + 5 }, untilUs: 8_000_000, reachMm });
      expect(Math.abs((found ?? 0) - timeUs)).toBeLessThanOrEqual(60_000);
    }
  });

  it('is none beside the trail, and none that is later than what is shown', async () => {
    const { chunks, seen } = await drive('from mbrobot import *\nforward()\ndelay(4000)', 2_000_000);
    const { x, y } = seen[90]!;
    expect(momentAt(chunks, { device: 0, at: { x, y: y + 20 }, untilUs: 2_000_000, reachMm })).toBeNull();
    expect(momentAt(chunks, { device: 0, at: { x, y }, untilUs: 1_000_000, reachMm })).toBeNull();
    expect(momentAt(chunks, { device: 1, at: { x, y }, untilUs: 2_000_000, reachMm })).toBeNull();
  });

  it('is the latest where it came by again, and where it stands the time at which it came there', async () => {
    const main = 'from mbrobot import *\nforward()\ndelay(1500)\nbackward()\ndelay(1000)\nstop()';
    const { chunks, seen } = await drive(main, 6_000_000);
    const there = seen.find(({ timeUs }) => timeUs >= 1_000_000)!;
    const again = momentAt(chunks, { device: 0, at: there, untilUs: 6_000_000, reachMm });
    expect(again).toBeGreaterThan(1_600_000);
    expect(again).toBeLessThan(2_400_000);
    const end = seen.at(-1)!;
    expect(momentAt(chunks, { device: 0, at: end, untilUs: 6_000_000, reachMm })).toBeLessThan(3_200_000);
  });
});

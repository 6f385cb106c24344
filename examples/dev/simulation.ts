import { readFileSync } from 'node:fs';

import { defaultScene } from '#scene/scene';
import { soloRun } from '#simulation/run-setup';
import { Simulation } from '#simulation/simulation';

import type { Print } from './example';

const PROGRAM = `from mbrobot import *
setSpeed(50)
forward()
delay(1000)
stop()
`;

/** simulation: a whole run without a page. The hash at the end is the same on every machine. */
export async function main(print: Print): Promise<void> {
  const firmware = new WebAssembly.Module(readFileSync('.cache/vm/vm.wasm'));
  const setup = {
    scene: defaultScene(),
    files: { 'main.py': PROGRAM },
    robot: 'maqueen-lite',
    board: 'auto',
    seed: 1,
    reality: 0,
  };
  const run = await Simulation.create(soloRun(setup), firmware);
  run.advanceTo(3_000_000);
  const { robot } = run.snapshot();
  print(`at x = ${Math.round(robot?.pose.xMm ?? 0)} mm, y = ${Math.round(robot?.pose.yMm ?? 0)} mm`);
  print(`trace ${run.traceHash}`);
}

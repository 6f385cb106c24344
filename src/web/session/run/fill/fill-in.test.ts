// @vitest-environment happy-dom
import { readFileSync } from 'node:fs';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { effectScope, type EffectScope } from 'vue';

import type { Snapshot } from '#simulation/snapshot';
import { Rows } from '#tape/rows/rows';
import { createParts, type AllParts } from '../../../app/testing/page';
import { workerHere } from '../../../app/testing/worker-here';
import { noHost } from '../../visit/host-view';
import { nothingKept } from '../../work/model/keep-work';
import { fillIn, fillInSilently } from './fill-in';
import { gapIn } from './gap';
import type { Recording } from '../recording';
import { wholeRecording } from './whole-recording';

const firmware = WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));
const PROGRAM = 'from mbrobot import *\nforward()\nfor i in range(30):\n    delay(100)\nstop()\n';
const STEP_US = 20_000;

let page: AllParts;
let scope: EffectScope;
beforeEach(() => {
  vi.stubGlobal('requestAnimationFrame', (draw: () => void) => setTimeout(draw, 5));
  vi.stubGlobal('cancelAnimationFrame', clearTimeout);
  localStorage.clear();
  scope = effectScope(true);
  page = scope.run(() => createParts(nothingKept, noHost, { createWorker: workerHere, firmware: () => firmware }))!;
});
afterEach(() => {
  scope.stop();
  vi.unstubAllGlobals();
});

const soon = <T>(look: () => T): Promise<T> => vi.waitFor(look, { timeout: 20_000, interval: 10 });
const rowsOf = ({ pieces }: Recording): Rows<Snapshot> => {
  const rows = new Rows<Snapshot>();
  for (const piece of pieces) expect(rows.push(piece)).not.toBeNull();
  return rows;
};
/** The times of all moments. */
function timesOf(recording: Recording): readonly number[] {
  const rows = rowsOf(recording);
  const times = new Set<number>();
  for (let us = 0; us <= rows.endUs; us += STEP_US) times.add(rows.at(us)?.timeUs ?? -1);
  return [...times];
}
const everyStep = (untilUs: number): readonly number[] =>
  Array.from({ length: untilUs / STEP_US + 1 }, (_, at) => at * STEP_US);

/** Runs the program to its end and returns its tape. */
async function driven(speed: 1 | 'max', act: () => void = () => undefined): Promise<Recording> {
  page.work.setText('main.py', PROGRAM);
  page.run.setSpeed(speed);
  await page.run.start();
  act();
  await soon(() => expect(page.run.hasEnded.value).toBe(true));
  const recording = page.run.recording.value;
  await soon(() => expect(recording.inputs.value).not.toBeNull());
  await page.run.stop();
  return recording;
}

describe('the tape of a run at full speed', () => {
  it('has a moment a second, and all of them once they are wanted', async () => {
    const recording = await driven('max');
    expect(timesOf(recording).length).toBeLessThan(10);
    await fillInSilently(recording, page.run);
    const { endUs } = rowsOf(recording);
    expect(endUs).toBeGreaterThanOrEqual(3_000_000);
    expect(timesOf(recording)).toEqual(everyStep(endUs));
    expect(gapIn(recording)).toBeNull();
  });

  it('shows then what the same run shows in real time', async () => {
    const press = (): void => void page.run.input({ type: 'button', button: 'a', down: true });
    const fast = await driven('max', press);
    await fillInSilently(fast, page.run);
    const slow = await driven(1, press);
    expect(gapIn(slow)).toBeNull();
    for (const us of [0, 1_000_000, 2_500_000, 3_000_000]) expect(rowsOf(fast).at(us)).toEqual(rowsOf(slow).at(us));
  });

  it('stays as it is when somebody gives that up, until there is more of it', async () => {
    const recording = await driven('max');
    const before = recording.pieces;
    let asked = 0;
    const giveUp = (): Promise<null> => {
      asked += 1;
      return Promise.resolve(null);
    };
    await Promise.all([fillIn(recording, giveUp), fillIn(recording, giveUp)]);
    await fillIn(recording, giveUp);
    expect([asked, recording.pieces === before]).toEqual([1, true]);
  });

  it('is whole from there on, too, where the run goes on after it was filled in', async () => {
    page.work.setText('main.py', PROGRAM);
    page.run.setSpeed('max');
    await page.run.start(true);
    page.run.step();
    await soon(() => expect(page.run.nowUs.value).toBeGreaterThan(0));
    page.run.resume();
    await soon(() => expect(page.run.nowUs.value).toBeGreaterThan(500_000));
    const recording = await wholeRecording(page.run, 'all moments');
    const wholeUs = rowsOf(recording!).endUs;
    page.run.setSpeed(1);
    page.run.look.leave();
    page.run.resume();
    await soon(() => expect(page.run.nowUs.value).toBeGreaterThan(wholeUs + 100_000));
    await wholeRecording(page.run, 'all moments');
    const { endUs } = rowsOf(recording!);
    expect(endUs).toBeGreaterThan(wholeUs);
    expect(timesOf(recording!)).toEqual(everyStep(endUs));
    await page.run.stop();
  });
});

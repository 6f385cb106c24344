import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';

import { defaultScene } from '#scene/scene';
import { soloRun, type RunSetup } from '#simulation/run-setup';
import { Simulation } from '#simulation/simulation';
import type { Snapshot } from '#simulation/snapshot';
import { OutputHashes, resultOf } from '#tape/result';
import { RowWriter } from '#tape/rows/row-writer';
import { Rows } from '#tape/rows/rows';
import { answerRepeat, type RepeatAnswer } from './repeat';

const firmware = await WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));
const PROGRAM = 'from mbrobot import *\nforward()\nfor i in range(10):\n    print(i)\n    delay(50)\nstop()\n';
const runOf = (robot: string): RunSetup =>
  soloRun({
    scene: defaultScene(),
    files: { 'main.py': PROGRAM },
    ...{ robot, board: 'microbit-v2', seed: 3, reality: 0.5 },
  });

/** The worker's messages if each look at the clock takes 60 ms. */
async function said(
  setup: RunSetup,
  untilUs: number,
  untilProgramEnds = false,
  momentsSinceUs = Infinity,
): Promise<readonly RepeatAnswer[]> {
  const all: RepeatAnswer[] = [];
  let ms = 0;
  const at = { post: (answer: RepeatAnswer) => void all.push(answer), nowMs: () => (ms += 60) };
  await answerRepeat({ type: 'repeat', firmware, setup, untilUs, untilProgramEnds, momentsSinceUs }, at);
  return all;
}

describe('a kept run that is run again', () => {
  it('comes to the same as at first, and shows its beginning', async () => {
    const setup = runOf('maqueen-lite');
    const output = new OutputHashes(1);
    const run = await Simulation.create(setup, firmware, { print: (text) => output.add(text, 0) });
    const first = run.snapshot();
    run.advanceTo(400_000);
    const [last] = (await said(setup, 400_000)).slice(-1);
    expect(last).toEqual({ type: 'repeated', repeated: { result: resultOf(run, output), first, pieces: [] } });
  });

  it('tells its moments after a time, the same as those of the run itself', async () => {
    const setup = runOf('maqueen-lite');
    const wanted: Snapshot[] = [];
    const run = await Simulation.create(setup, firmware, { moment: (snapshot) => wanted.push(snapshot) });
    run.advanceTo(400_000);
    const [last] = (await said(setup, 400_000, false, 200_000)).slice(-1);
    if (last?.type !== 'repeated') throw new Error('It did not come to its end.');
    const [again, first] = [new Rows<Snapshot>(), new RowWriter()];
    for (const piece of last.repeated.pieces) again.push(piece);
    const later = wanted.filter(({ timeUs }) => timeUs > 200_000);
    for (const moment of later) first.add(moment);
    expect(again.at(0)?.timeUs).toBe(220_000);
    expect(last.repeated.pieces).toEqual([first.finish()]);
  });

  it('says meanwhile how far it is', async () => {
    const answers = await said(runOf('maqueen-lite'), 600_000);
    expect(answers.flatMap((answer) => (answer.type === 'repeating' ? [answer.nowUs] : []))).toEqual([
      200_000, 400_000, 600_000,
    ]);
  });

  it('ends with its programs, if it is to', async () => {
    const [last] = (await said(runOf('maqueen-lite'), 60_000_000, true)).slice(-1);
    if (last?.type !== 'repeated') throw new Error('It did not come to its end.');
    expect(last.repeated.result.devices).toMatchObject([{ ended: 'finished' }]);
    expect(last.repeated.result.simulatedUs).toBeLessThan(700_000);
  });

  it('says why it cannot be run', async () => {
    expect(await said(runOf('k9'), 1_000)).toMatchObject([{ type: 'failed', message: expect.stringContaining('k9') }]);
  });
});

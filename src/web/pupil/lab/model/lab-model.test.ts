import { describe, expect, it } from 'vitest';

import type { Answer } from '#check/lane';
import type { Outcome } from '#lab/outcome';
import type { RunAnswer, RunRequest } from '#lab/run-request';
import { sweepJson } from '#lab/sweep-texts';
import { defaultScene } from '#scene/scene';
import { soloRun } from '#simulation/run-setup';
import { LabModel, ROBOTS, type Wish } from './lab-model';

const outcome: Outcome = {
  ...{ passed: true, atMs: 4000, touches: 0, reason: null },
  ...{ xMm: 1, yMm: 2, headingDeg: 3, pathMm: 4, traceHash: 'x' },
};
const program = (ms: number): string => `from mbrobot import *\nforward()\ndelay(${ms})\n`;
const setupOf = (text: string) =>
  soloRun({
    ...{ scene: defaultScene(), files: { 'main.py': text }, robot: 'auto', board: 'auto', seed: 1, reality: 0 },
  });

/** A lab whose threads answer at once, as `answer` says. */
function lab(lanes: number, answer: (request: RunRequest, place: number) => Answer<RunAnswer> | null) {
  const asked: RunRequest[] = [];
  let setup = setupOf(program(650));
  const ports = {
    setup: () => ({ setup, usedSeed: 7 }),
    starter: () =>
      Promise.resolve((heard: (answer: Answer<RunAnswer>) => void) => ({
        ask(request: RunRequest) {
          asked.push(request);
          const said = answer(request, asked.length);
          if (said !== null) queueMicrotask(() => heard(said));
        },
        pulse: () => ({ beat: 0, world: 0 }),
        stop: () => undefined,
      })),
    every: () => () => undefined,
    ...{ lanes, nowMs: () => 1000 * asked.length, later: (act: () => void) => act() },
  };
  const become = (text: string): void => void (setup = setupOf(text));
  return { model: new LabModel(ports), asked, become };
}
const drive = { way: [], endUs: 4_000_000, lineMm: [] };
const good = (): Answer<RunAnswer> => ({ result: { outcome, verdict: null, drive } });
const wish: Wish = { kind: 'ranges', ranges: [{ name: 'main.py:3', from: 400, to: 900, step: 20 }] };
const numbersOf = (asked: readonly RunRequest[]): readonly number[] =>
  asked.map(({ setup: { devices } }) => Number(/delay\((\d+)\)/.exec(devices[0].files['main.py'] ?? '')?.[1]));

describe('a series of runs', () => {
  it('tries coarse steps first, then between, and asks for each way', async () => {
    const { model, asked } = lab(1, good);
    await model.begin(wish);
    expect(numbersOf(asked).slice(0, 9)).toEqual([400, 440, 480, 520, 560, 600, 640, 680, 720]);
    expect(new Set(numbersOf(asked)).size).toBe(26);
    expect(asked.every(({ withDrive }) => withDrive === true)).toBe(true);
  });

  it('is the same table with one worker and with four, in the order of the values', async () => {
    const texts = [];
    for (const lanes of [1, 4]) {
      const { model } = lab(lanes, good);
      await model.begin(wish);
      texts.push(sweepJson(model.result()));
      expect(model.inOrder.value.map(({ values }) => values[0])).toEqual(Array.from({ length: 26 }, (_, at) => 400 + 20 * at)); // prettier-ignore
    }
    expect(texts[0]).toBe(texts[1]);
  });

  it('stops, and keeps what has come', async () => {
    const { model } = lab(1, (_, place) => (place > 5 ? null : good()));
    void model.begin(wish);
    await new Promise((done) => setTimeout(done, 5));
    expect(model.isRunning.value).toBe(true);
    model.stop();
    expect(model.isRunning.value).toBe(false);
    expect(model.inOrder.value).toHaveLength(5);
    expect([model.tookMs.value, model.estimateMs(10, 0)]).toEqual([6000, 12_000]);
  });

  it('shows the run that is chosen, and its set-up with the number in the program', async () => {
    const { model } = lab(2, good);
    await model.begin(wish);
    model.chosen.value = 18;
    expect(model.chosenRun.value?.values).toEqual([760]);
    expect(model.setupAt(18)?.devices[0].files['main.py']).toBe(program(760));
  });

  it('tries fifty robots as used ones, though the page has a new one', async () => {
    const { model, asked } = lab(2, good);
    await model.begin({ kind: 'robots' });
    expect(asked.map(({ setup: { seed, reality } }) => [seed, reality])).toEqual(
      Array.from({ length: ROBOTS }, (_, at) => [at + 1, 1]),
    );
  });

  it('asks the same again of the line that has moved, also after a number was taken from it', async () => {
    const { model, become } = lab(1, good);
    await model.begin(wish);
    become(`# mine\n${program(650)}`);
    expect(model.wishNow()).toMatchObject({ ranges: [{ name: 'main.py:4', from: 400 }] });
    model.taken.value = 18;
    become(`# mine\n${program(760)}`);
    expect(model.wishNow()).toMatchObject({ ranges: [{ name: 'main.py:4', from: 400 }] });
    become('from mbrobot import *\n');
    expect(model.wishNow()).toBeNull();
  });

  it('says so when a run is refused, and when there are too many', async () => {
    const { model } = lab(2, () => ({ result: { refused: 'no' } }));
    await model.begin(wish);
    expect(model.failure.value).toBe('refused');
    const ranges = [{ name: 'main.py:3', from: 1, to: 5000, step: 1 }];
    const other = lab(1, good).model;
    expect([await other.begin({ kind: 'ranges', ranges }), other.failure.value]).toEqual([false, 'unclear']);
    expect(other.isRunning.value).toBe(false);
  });
});

// @vitest-environment happy-dom
import { readFileSync } from 'node:fs';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { effectScope, type EffectScope } from 'vue';

import type { Answer } from '#check/lane';
import { targetAt } from '#check/testing/tasks';
import { answerRun, type RunAnswer, type RunRequest } from '#lab/run-request';

import { createParts, type AllParts } from '../../app/testing/page';
import { workerHere } from '../../app/testing/worker-here';
import { noHost } from '../../session/visit/host-view';
import { nothingKept } from '../../session/work/model/keep-work';
import { lookBackOn } from './act-on-run';
import { LabModel, type Wish } from './model/lab-model';
import { labOf } from './use-lab';

const firmware = WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));
let page: AllParts;
let scope: EffectScope;
beforeEach(() => {
  vi.stubGlobal('requestAnimationFrame', (draw: () => void) => setTimeout(draw, 5));
  vi.stubGlobal('cancelAnimationFrame', clearTimeout);
  localStorage.clear();
  sessionStorage.clear();
  scope = effectScope(true);
  page = scope.run(() => createParts(nothingKept, noHost, { createWorker: workerHere, firmware: () => firmware }))!;
});
afterEach(() => {
  scope.stop();
  vi.unstubAllGlobals();
});

/** A lab of the page whose runs are made in the thread of the test. */
const labHere = (): LabModel =>
  new LabModel({
    setup: () => labOf(page).base(),
    starter: async () => {
      const vm = await firmware;
      return (heard: (answer: Answer<RunAnswer>) => void) => ({
        ask: (request: RunRequest) =>
          void answerRun(request, { firmware: vm, beat: () => undefined }).then((result) => heard({ result })),
        pulse: () => ({ beat: 0, world: 0 }),
        stop: () => undefined,
      });
    },
    every: () => () => undefined,
    ...{ lanes: 1, nowMs: () => 0, later: (act: () => void) => act() },
  });

const DRIVE = 'from mbrobot import *\nforward()\ndelay(650)\nstop()\n';
const number: Wish = { kind: 'ranges', ranges: [{ name: 'main.py:3', from: 500, to: 4000, step: 3500 }] };
const condition: Wish = { kind: 'ranges', ranges: [{ name: 'reality', from: 0, to: 1, step: 1 }] };

describe('Rückblick on a point of a series', { timeout: 60_000 }, () => {
  it.each<[string, boolean, Wish]>([
    ['that ends with its program', false, number],
    ['that ends with the task', true, number],
    ['of a new and a used robot', true, condition],
  ])('opens the run of the series, with its fingerprint: one %s', async (_, hasGoal, wish) => {
    page.work.setText('main.py', DRIVE);
    if (hasGoal) page.work.edit({ type: 'add', objects: [targetAt(900, 450)] });
    const lab = labHere();
    await lab.begin(wish);
    const runs = lab.series.value?.runs;
    expect(runs?.get(0)?.traceHash).not.toBe(runs?.get(1)?.traceHash);
    for (const place of [0, 1]) {
      const left = vi.fn();
      const hash = await lookBackOn(page, { lab, place, signal: new AbortController().signal }, left);
      expect(hash).toBe(runs?.get(place)?.traceHash);
      expect(hash).toMatch(/^[0-9a-f]{16,}$/);
      expect(left).toHaveBeenCalledOnce();
      const endUs = runs?.get(place)?.drive?.endUs;
      await vi.waitFor(() => expect(page.run.present.value?.timeUs).toBe(endUs), { timeout: 20_000, interval: 20 });
    }
  });
});

import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';

import { handInOfFiles } from '#check/hand-in/read-hand-in';
import { projectOfTask } from '#check/task/write-task';
import { soloRun } from '#simulation/run-setup';
import { ahead, sceneWith, targetAt, taskWith } from '#check/testing/tasks';

import type { FromServer } from './protocol';
import { Server } from './server';

let firmware: WebAssembly.Module;
beforeAll(() => {
  firmware = new WebAssembly.Module(readFileSync('.cache/vm/vm.wasm'));
});

/** A server, and its messages. */
function server() {
  const said: FromServer[] = [];
  let nowMs = 0;
  const made = new Server({ post: (message) => void said.push(message), nowMs: () => (nowMs += 10) });
  const hand = (text: string) =>
    made.receive({ type: 'serve', request: { handIn: handInOfFiles([{ name: 'main.py', text }]) } });
  return { made, said, hand };
}

describe('a worker that serves beside the run', () => {
  const task = taskWith(sceneWith([targetAt(700, 450)]));

  it('answers with the result, and shows signs of life meanwhile', async () => {
    const { made, said, hand } = server();
    await made.receive({
      ...{ type: 'serve-open', firmware },
      opening: { service: 'check', task: projectOfTask(task), starts: [] },
    });
    await hand(ahead(3000));
    expect(said.at(-1)).toMatchObject({ type: 'served', answer: { result: { passed: true } } });
    expect(said.slice(0, -1).every(({ type }) => type === 'serve-beat')).toBe(true);
    expect(said.length).toBeGreaterThan(1);
    await hand('x = 1');
    expect(said.at(-1)).toMatchObject({ answer: { result: { passed: false } } });
  });

  it('makes runs', async () => {
    const { made, said } = server();
    await made.receive({ type: 'serve-open', opening: { service: 'runs' }, firmware });
    const { scene } = task.project;
    const end = { untilUs: 20_000_000, untilProgramEnds: false, untilVerdict: true };
    for (const ms of [100, 3000]) {
      const setup = soloRun({
        ...{ scene, files: { 'main.py': ahead(ms) }, robot: 'auto', board: 'auto', seed: 1, reality: 0 },
      });
      await made.receive({ type: 'serve', request: { setup, end } });
      expect(said.at(-1)).toMatchObject({ answer: { result: { outcome: { passed: ms === 3000 } } } });
    }
  });

  it('finds a hint to a program', async () => {
    const { made, said } = server();
    await made.receive({
      ...{ type: 'serve-open', firmware },
      opening: { service: 'hint', task: projectOfTask(task) },
    });
    const handIn = handInOfFiles([{ name: 'main.py', text: ahead(10) }]);
    await made.receive({ type: 'serve', request: { handIn, budget: 0 } });
    expect(said.at(-1)).toMatchObject({ answer: { result: { change: null, tried: 0 } } });
  });

  it('says so when no service is open', async () => {
    const { said, hand } = server();
    await hand(ahead(3000));
    expect(said).toEqual([{ type: 'served', answer: { broken: 'No service is open.' } }]);
  });
});

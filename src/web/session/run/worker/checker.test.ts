import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';

import { handInOfFiles } from '#check/hand-in/read-hand-in';
import { projectOfTask } from '#check/task/write-task';
import { ahead, sceneWith, targetAt, taskWith } from '#check/testing/tasks';

import { Checker, type FromChecker } from './checker';

let firmware: WebAssembly.Module;
beforeAll(() => {
  firmware = new WebAssembly.Module(readFileSync('.cache/vm/vm.wasm'));
});

/** A checker, and its messages. */
function checker() {
  const said: FromChecker[] = [];
  let nowMs = 0;
  const made = new Checker({ post: (message) => void said.push(message), nowMs: () => (nowMs += 10) });
  const hand = (text: string) =>
    made.receive({ type: 'check', request: { handIn: handInOfFiles([{ name: 'main.py', text }]) } });
  return { made, said, hand };
}

describe('the worker that checks hand-ins', () => {
  const task = taskWith(sceneWith([targetAt(700, 450)]));

  it('answers with the result, and shows signs of life meanwhile', async () => {
    const { made, said, hand } = checker();
    await made.receive({ type: 'check-open', task: projectOfTask(task), starts: [], firmware });
    await hand(ahead(3000));
    expect(said.at(-1)).toMatchObject({ type: 'checked', answer: { result: { passed: true } } });
    expect(said.slice(0, -1).every(({ type }) => type === 'check-beat')).toBe(true);
    expect(said.length).toBeGreaterThan(1);
    await hand('x = 1');
    expect(said.at(-1)).toMatchObject({ answer: { result: { passed: false } } });
  });

  it('says so when it was given no task', async () => {
    const { said, hand } = checker();
    await hand(ahead(3000));
    expect(said).toEqual([{ type: 'checked', answer: { broken: 'There is no task.' } }]);
  });
});

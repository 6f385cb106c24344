import { describe, expect, it } from 'vitest';
import type { CheckRequest, StartThread } from '#check/lane';
import { unreadable } from '#check/result';
import { sceneWith, targetAt, taskWith } from '#check/testing/tasks';
import { SolutionRun } from './solution-run';

const task = taskWith(sceneWith([targetAt(700, 450)]));
const withSolution = (text: string) => ({ ...task, solution: [{ name: 'main.py', text }] });

/** Threads that answer at once: whoever writes `forward` passes. */
function running() {
  const asked: string[] = [];
  const start: StartThread = (heard) => ({
    ask({ handIn }: CheckRequest) {
      const text = handIn.project.files[0]?.text ?? '';
      asked.push(text);
      const nothing = unreadable(task.checks, { code: 'zip', params: {} });
      queueMicrotask(() => heard({ result: { ...nothing, passed: text.includes('forward') } }));
    },
    pulse: () => ({ beat: 0, world: 0 }),
    stop: () => undefined,
  });
  const run = new SolutionRun({ starter: () => Promise.resolve(start), every: () => () => undefined });
  return { run, asked };
}

describe('the model solution', () => {
  it('is run in place of the program that is open', async () => {
    const { run, asked } = running();
    await run.run(withSolution('forward()'));
    expect([asked, run.result.value?.passed, run.isRunning.value]).toEqual([['forward()'], true, false]);
    await run.run(withSolution('stop()'));
    expect(run.result.value?.passed).toBe(false);
  });

  it('that is not there has no result', async () => {
    const { run, asked } = running();
    await run.run({ ...task, solution: null });
    expect([asked, run.result.value]).toEqual([[], null]);
  });

  it('has the result of the newest task, whatever was running', async () => {
    const { run } = running();
    const first = run.run(withSolution('stop()'));
    await Promise.all([first, run.run(withSolution('forward()'))]);
    expect(run.result.value?.passed).toBe(true);
  });

  it('says so when nothing can be run', async () => {
    const run = new SolutionRun({ starter: () => Promise.reject(new Error('offline')), every: () => () => undefined });
    await run.run(withSolution('forward()'));
    expect([run.hasFailed.value, run.isRunning.value]).toEqual([true, false]);
  });
});

import { describe, expect, it } from 'vitest';
import type { CheckRequest, StartThread } from '#check/lane';
import { unreadable } from '#check/result';
import { sceneWith, targetAt, taskWith } from '#check/testing/tasks';
import { CheckRun } from './check-run';

const task = taskWith(sceneWith([targetAt(700, 450)]));
const project = (text: string) => ({ ...task.project, files: [{ name: 'main.py', text }] });

/** Threads that answer immediately: a program with `forward` passes. */
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
  const run = new CheckRun({ starter: () => Promise.resolve(start), every: () => () => undefined });
  return { run, asked };
}

describe('a program that is checked again and again', () => {
  it('is run each time it is asked for', async () => {
    const { run, asked } = running();
    await run.run(task, project('forward()'));
    expect([asked, run.result.value?.passed, run.isRunning.value]).toEqual([['forward()'], true, false]);
    await run.run(task, project('stop()'));
    expect(run.result.value?.passed).toBe(false);
  });

  it('has no result if it is not there', async () => {
    const { run, asked } = running();
    await run.run(task, null);
    expect([asked, run.result.value]).toEqual([[], null]);
  });

  it('has the result of the newest one, whatever was running', async () => {
    const { run } = running();
    const first = run.run(task, project('stop()'));
    await Promise.all([first, run.run(task, project('forward()'))]);
    expect(run.result.value?.passed).toBe(true);
  });

  it('says so when nothing can be run', async () => {
    const run = new CheckRun({ starter: () => Promise.reject(new Error('offline')), every: () => () => undefined });
    await run.run(task, project('forward()'));
    expect([run.failure.value, run.isRunning.value]).toEqual(['notice.firmware', false]);
  });
});

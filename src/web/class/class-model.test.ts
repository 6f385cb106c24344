import { describe, expect, it, vi } from 'vitest';

import { brokenSource, fileSource, type Source } from '#check/hand-in/sources';
import type { CheckRequest, StartThread } from '#check/lane';
import { unreadable } from '#check/result';
import { ahead, sceneWith, targetAt, taskWith } from '#check/testing/tasks';

import { ClassModel, type ClassPorts } from './class-model';

const task = taskWith(sceneWith([targetAt(700, 450)]));
const program = (name: string, text: string): Source =>
  fileSource({ path: `${name}.py`, read: () => ({ bytes: new TextEncoder().encode(text) }) }, () => null);

/** A class whose threads answer at once: whoever writes `forward` passes. */
function classWith(more: Partial<ClassPorts> = {}) {
  const asked: string[] = [];
  const start: StartThread = (heard) => ({
    ask({ handIn }: CheckRequest) {
      const text = handIn.project.files[0]?.text ?? '';
      asked.push(text);
      const result = {
        ...unreadable(task.checks, { code: 'zip', params: {} }),
        passed: text.includes('forward'),
        remarks: [],
        twin: text,
      };
      queueMicrotask(() => heard({ result }));
    },
    pulse: () => ({ beat: 0, world: 0 }),
    stop: () => undefined,
  });
  const model = new ClassModel({ starter: () => Promise.resolve(start), every: () => () => undefined, lanes: 2, ...more }); // prettier-ignore
  const passed = () => model.rows.value.map(({ name, result }) => [name, result?.passed ?? null]);
  return { model, asked, passed };
}

describe('a class', () => {
  it('is checked as soon as there are a task and hand-ins', async () => {
    const { model, passed } = classWith();
    await model.add([program('Ada', ahead(3000)), program('Ben', 'x = 1')]);
    expect(passed()).toEqual([['Ada', null], ['Ben', null]]); // prettier-ignore
    await model.choose({ name: 'T', from: 'open', task });
    expect(passed()).toEqual([['Ada', true], ['Ben', false]]); // prettier-ignore
    expect(model.isChecking.value).toBe(false);
  });

  it('checks only what is new, and everything again for another task', async () => {
    const { model, asked } = classWith();
    await model.choose({ name: 'T', from: 'open', task });
    await model.add([program('Ada', ahead(3000))]);
    await model.add([program('Ben', 'x = 1')]);
    expect(asked).toHaveLength(2);
    await model.choose({ name: 'U', from: 'open', task });
    expect(asked).toHaveLength(4);
  });

  it('gives each of several with one name its own, tells of twins and of what cannot be read', async () => {
    const { model } = classWith();
    await model.choose({ name: 'T', from: 'open', task });
    await model.add([program('Ada', ahead(3000)), brokenSource('Tim', { code: 'zip', params: {} })]);
    await model.add([program('Ada', ahead(3000))]);
    const told = model.found.value.handIns.map(({ name, result }) => [name, result.remarks.map(({ code }) => code)]);
    expect(told).toEqual([['Ada', ['twins']], ['Tim', ['unreadable']], ['Ada (2)', ['twins']]]); // prettier-ignore
  });

  it('that is taken away while it is checked, is gone for good', async () => {
    const { model } = classWith({ starter: () => new Promise(() => undefined) });
    await model.choose({ name: 'T', from: 'open', task });
    void model.add([program('Ada', ahead(3000))]);
    expect(model.isChecking.value).toBe(true);
    model.clear();
    expect([model.rows.value, model.isChecking.value]).toEqual([[], false]);
  });

  it('says when nothing can be checked, and tries again with the next hand-in', async () => {
    const starter = vi.fn().mockRejectedValue(new Error('offline'));
    const { model } = classWith({ starter });
    await model.choose({ name: 'T', from: 'open', task });
    await model.add([program('Ada', ahead(3000))]);
    expect([model.hasFailed.value, model.isChecking.value]).toEqual([true, false]);
    await model.add([program('Ben', ahead(3000))]);
    expect(starter).toHaveBeenCalledTimes(2);
  });
});

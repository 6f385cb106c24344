import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';

import { brokenSource } from '#check/hand-in/sources';
import { ahead, sceneWith, targetAt, taskWith } from '#check/testing/tasks';

import { stubDatabase } from '../work/storage/testing/memory-database';
import { ClassKeeper } from './class-keeper';
import { classWith, program } from './testing/class';

const task = taskWith(sceneWith([targetAt(700, 450)]));

beforeEach(() => void vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] }));
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

/** A class on a page that has just been loaded. */
async function loaded() {
  const made = classWith();
  const keeper = new ClassKeeper(made.model);
  await vi.waitUntil(() => keeper.isReady.value);
  return { ...made, keeper };
}

/** A class with a program, something that cannot be read, and a note. */
async function classOfTwo() {
  const made = await loaded();
  await made.model.choose({ name: 'T', from: 'open', task });
  await made.model.add([program('Ada', ahead(3000)), brokenSource('Tim', { code: 'zip', params: {} })]);
  made.model.write('Ada', 'gut');
  return made;
}

describe('a class in the browser', () => {
  it('is not kept unless somebody wants that', async () => {
    const { entries } = stubDatabase();
    const { keeper } = await classOfTwo();
    await vi.runAllTimersAsync();
    expect([keeper.isKept.value, entries.size]).toEqual([false, 0]);
  });

  it('is there again after a reload, with task, hand-ins, results and notes, and nothing is checked again', async () => {
    stubDatabase();
    const { model, keeper } = await classOfTwo();
    await keeper.keep(true);
    const again = await loaded();
    expect(again.keeper.isKept.value).toBe(true);
    expect(again.model.task.value).toEqual({ name: 'T', from: 'kept', task });
    expect(again.model.rows.value).toEqual(model.rows.value);
    expect(again.asked).toEqual([]);
    await again.model.choose({ name: 'U', from: 'file', task });
    expect(again.asked).toEqual([ahead(3000)]); // for another task its program is there to be run
  });

  it('is kept as it changes: more hand-ins, notes, none any more', async () => {
    stubDatabase();
    const { model, keeper } = await classOfTwo();
    await keeper.keep(true);
    await model.add([program('Ben', 'x = 1')]);
    model.write('Ben', 'fast');
    await vi.runAllTimersAsync();
    expect((await loaded()).model.rows.value.map(({ name, note }) => [name, note])).toEqual([
      ['Ada', 'gut'],
      ['Tim', ''],
      ['Ben', 'fast'],
    ]);
    model.clear();
    await vi.runAllTimersAsync();
    expect((await loaded()).model.rows.value).toEqual([]);
  });

  it('is forgotten when somebody wants that, and stays on the page', async () => {
    const { entries } = stubDatabase();
    const { model, keeper } = await classOfTwo();
    await keeper.keep(true);
    expect(entries.size).toBe(3);
    await keeper.keep(false);
    await vi.runAllTimersAsync();
    expect([entries.size, model.rows.value.length]).toEqual([0, 2]);
  });

  it('that the browser has no room for is told, and stays on the page', async () => {
    stubDatabase(false);
    const { model, keeper } = await classOfTwo();
    await keeper.keep(true);
    expect([keeper.problem.value, keeper.isKept.value, model.rows.value.length]).toEqual(['failed', false, 2]);
  });

  it('that cannot be read any more is told, and is gone', async () => {
    const { entries } = stubDatabase();
    entries.set('class.task', { name: 'class.task', usedMs: 0, text: '{"version":99}' } as never);
    const { keeper } = await loaded();
    expect([keeper.problem.value, keeper.isKept.value, entries.size]).toEqual(['lost', false, 0]);
  });

  it('is not offered where there is no database, but is checked all the same', async () => {
    vi.stubGlobal('indexedDB', undefined);
    const { model, keeper } = await classOfTwo();
    expect(model.found.value.handIns).toHaveLength(2);
    await keeper.keep(true);
    expect(keeper.problem.value).toBe('failed');
  });
});

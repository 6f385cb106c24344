import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';

import { brokenSource } from '#intake/sources';
import { ahead, sceneWith, targetAt, taskWith } from '#check/testing/tasks';

import { stubDatabase } from '../../session/work/storage/testing/memory-database';
import { ClassKeeper } from './class-keeper';
import type { ClassNews, ClassTabs } from './class-tabs';
import { classWith, program } from './model/testing/class';

const task = taskWith(sceneWith([targetAt(700, 450)]));

beforeEach(() => void vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] }));
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

const alone: ClassTabs = { tell: () => undefined, hear: () => undefined };

/** Tabs of one browser: each is heard by the others. */
function browser(): () => ClassTabs {
  const hearers: ((news: ClassNews) => void)[][] = [];
  return () => {
    const own: ((news: ClassNews) => void)[] = [];
    hearers.push(own);
    return {
      tell: (news) => hearers.filter((some) => some !== own).forEach((some) => some.forEach((told) => told(news))),
      hear: (told) => void own.push(told),
    };
  };
}

/** A class on a page that has just been loaded. */
async function loaded(tabs = alone) {
  const made = classWith();
  const keeper = new ClassKeeper(made.model, tabs);
  await vi.waitUntil(() => keeper.isReady.value);
  return { ...made, keeper };
}

/** A class with a program, something that cannot be read, and a note. */
async function classOfTwo(tabs = alone) {
  const made = await loaded(tabs);
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

  it('is reported if the browser has no room for it, and stays on the page', async () => {
    stubDatabase(false);
    const { model, keeper } = await classOfTwo();
    await keeper.keep(true);
    expect([keeper.problem.value, keeper.isKept.value, model.rows.value.length]).toEqual(['failed', false, 2]);
  });

  it('is reported if it cannot be read any more, and is gone', async () => {
    const { entries } = stubDatabase();
    entries.set('class.task', { name: 'class.task', usedMs: 0, text: '{"version":99}' });
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

describe('a class that is kept in two tabs', () => {
  const namesIn = ({ model }: Awaited<ReturnType<typeof loaded>>): readonly string[] =>
    model.rows.value.map(({ name, note }) => `${name} ${note}`.trim());
  /** It is kept in one and was opened in the other. */
  async function twoTabs() {
    const { entries } = stubDatabase();
    const tab = browser();
    const one = await classOfTwo(tab());
    await one.keeper.keep(true);
    return { one, other: await loaded(tab()), entries };
  }

  it('is the same in both: each follows what the other one changes, checks nothing again, and says so', async () => {
    const { one, other } = await twoTabs();
    await other.model.add([program('Ben', 'x = 1')]);
    await vi.runAllTimersAsync();
    expect([namesIn(one), one.asked.length, one.keeper.isShared.value]).toEqual([['Ada gut', 'Tim', 'Ben'], 1, true]);
    one.model.write('Ben', 'schnell');
    await vi.runAllTimersAsync();
    expect(namesIn(other)).toEqual(['Ada gut', 'Tim', 'Ben schnell']);
    expect([one.keeper.problem.value, other.keeper.problem.value]).toEqual([null, null]);
  });

  it('is changed in both at once: the later tab says so, writes over nothing, and keeps what it has on the page', async () => {
    const { one, other } = await twoTabs();
    one.model.write('Ada', 'von hier');
    other.model.write('Tim', 'von dort');
    await vi.runAllTimersAsync();
    expect([one.keeper.problem.value, other.keeper.problem.value]).toEqual([null, 'other']);
    expect([namesIn(one), namesIn(other)]).toEqual([['Ada von hier', 'Tim'], ['Ada gut', 'Tim von dort']]); // prettier-ignore
    expect(other.keeper.isKept.value).toBe(false);
    await other.keeper.takeOther();
    expect([namesIn(other), other.keeper.isKept.value]).toEqual([['Ada von hier', 'Tim'], true]);
  });

  it('is followed by the other tab if this one is chosen instead', async () => {
    const { one, other } = await twoTabs();
    one.model.write('Ada', 'von hier');
    other.model.write('Tim', 'von dort');
    await vi.runAllTimersAsync();
    await other.keeper.keepThis();
    await vi.runAllTimersAsync();
    expect([namesIn(one), other.keeper.problem.value]).toEqual([['Ada gut', 'Tim von dort'], null]);
  });

  it('is not written over by a tab that was open before with a class of its own', async () => {
    stubDatabase();
    const tab = browser();
    const early = await loaded(tab());
    const one = await classOfTwo(tab());
    await one.keeper.keep(true);
    await early.model.add([program('Zoe', 'x = 1')]);
    await early.keeper.keep(true);
    expect([early.keeper.problem.value, namesIn(early)]).toEqual(['other', ['Zoe']]);
    expect(namesIn(await loaded(tab()))).toEqual(['Ada gut', 'Tim']);
  });

  it('is kept no longer when one of them ends it: the other says so, and both still show it', async () => {
    const { one, other, entries } = await twoTabs();
    await one.keeper.keep(false);
    await vi.runAllTimersAsync();
    expect([entries.size, other.keeper.isKept.value, other.keeper.problem.value]).toEqual([0, false, 'ended']);
    expect([namesIn(one), namesIn(other)]).toEqual([['Ada gut', 'Tim'], ['Ada gut', 'Tim']]); // prettier-ignore
  });
});

import { describe, expect, it, vi } from 'vitest';
import { shallowRef } from 'vue';

import { handInOfFiles } from '#check/hand-in/read-hand-in';
import type { Start } from '#check/lane';
import { unreadable, type CheckResult } from '#check/result';
import { readyScene, taskWith } from '#check/testing/tasks';
import type { GroupHint } from '#hint/groups/group-hint';
import type { RunFacts } from '#hint/groups/run-facts';

import type { Row } from '../model/class-model';
import { GroupsModel } from './groups-model';

const UNMOVED: RunFacts = {
  ...{ world: 'visible', happened: { fact: 'unmoved' }, at: [0, 0], next: null },
  ...{ departure: null, stays: false, bend: null },
};
const row = (name: string, passed: boolean): Row => {
  const result: CheckResult = { ...unreadable([], { code: 'zip', params: {} }), passed, remarks: [] };
  return { name, shown: name, handIn: handInOfFiles([{ name: 'main.py', text: name }]), result, note: '' };
};

/** Groups whose workers answer at once, and the names of the programs they were asked about. */
function groupsWith(rows: readonly Row[], others: GroupHint['changes'] = [null], isThere = () => true) {
  const [looked, searched]: [string[], string[][]] = [[], []];
  const thread =
    <Request, Result>(answer: (request: Request) => Result): Start<Request, Result> =>
    (heard) => ({
      ask: (request) => queueMicrotask(() => heard(isThere() ? { result: answer(request) } : { unloaded: true })),
      pulse: () => ({ beat: 0, world: 0 }),
      stop: () => undefined,
    });
  const textOf = ({ project }: { readonly project: { readonly files: readonly { readonly text: string }[] } }) =>
    project.files[0]?.text ?? '';
  const change = { kind: 'number', line: 1, before: ['b'], after: ['d'], direction: 'more' } as const;
  const hint = {
    ...{ hint: { world: null, happened: { fact: 'unmoved' } }, holds: 1, of: 2 },
    changes: [change, ...others],
  } as unknown as GroupHint;
  const model = {
    task: shallowRef({ name: 'corners', from: 'corners', task: taskWith(readyScene('corners')) }),
    rows: shallowRef(rows),
  };
  const groups = new GroupsModel(model, {
    looker: () => Promise.resolve(thread(({ handIn }) => (looked.push(textOf(handIn)), UNMOVED))),
    hinter: () => Promise.resolve(thread(({ handIns }) => (searched.push(handIns.map(textOf)), hint))),
    ...{ every: () => () => undefined, lanes: 2 },
  });
  return { groups, model, looked, searched };
}

describe('the groups of the class on the page', () => {
  it('look at the runs of those alone who have not passed, and at each once', async () => {
    const { groups, model, looked } = groupsWith([row('a', true), row('b', false), row('c', false)]);
    expect(groups.waiting.value).toBe(2);
    await groups.look();
    model.rows.value = [...model.rows.value, row('d', false)];
    await groups.look();
    expect(looked.toSorted()).toEqual(['b', 'c', 'd']);
    expect(groups.waiting.value).toBe(0);
    expect(groups.groups.value.map(({ members }) => members)).toEqual([['a'], ['b', 'c', 'd']]);
  });

  it('search the hint to a group once, for its example first', async () => {
    const { groups, searched } = groupsWith([row('b', false), row('c', false)]);
    await groups.look();
    const [group] = groups.groups.value;
    await groups.search(group!);
    await groups.search(group!);
    expect(searched).toEqual([[group!.example, ...group!.members.filter((name) => name !== group!.example)]]);
    expect(groups.hintOf(group!)).toMatchObject({ holds: 1, of: 2 });
  });

  it('have the hint in words for those alone in whose programs it was tried and holds, without the change', async () => {
    const { groups } = groupsWith([row('b', false), row('c', false)]);
    await groups.look();
    const [group] = groups.groups.value;
    expect(groups.hintsInWords(group!, 'en').size).toBe(0);
    await groups.search(group!);
    const told = [...groups.hintsInWords(group!, 'en')];
    expect(told).toEqual([[group!.example, expect.stringMatching(/^The robot never moved\. .*line 1 is too small/)]]);
  });

  it('say to others than the example only what was tried out in their own programs', async () => {
    const less = { kind: 'number', line: 1, before: ['9'], after: ['5'], direction: 'less' } as const;
    const { groups } = groupsWith([row('b', false), row('c', false)], [less]);
    await groups.look();
    const [group] = groups.groups.value;
    await groups.search(group!);
    const other = group!.members.find((name) => name !== group!.example);
    expect(groups.hintsInWords(group!, 'en').get(other!)).toMatch(/^A number in line 1 is too big\. .*a smaller one/);
  });

  it('say what could not be looked at or searched as a part of the page did not load, and search again later', async () => {
    let isThere = false;
    const { groups, model } = groupsWith([row('b', false)], [null], () => isThere);
    await groups.look();
    expect(groups.groups.value).toMatchObject([{ is: { kind: 'unseen', reason: { code: 'unloaded' } } }]);
    isThere = true;
    model.rows.value = [row('b', false)];
    await groups.look();
    const [group] = groups.groups.value;
    isThere = false;
    await groups.search(group!);
    expect(groups.hintOf(group!)).toBe('unloaded');
    isThere = true;
    await groups.search(group!);
    expect(groups.hintOf(group!)).toMatchObject({ holds: 1 });
  });

  it('end a search with the group that is closed, and begin it anew', async () => {
    const { groups, searched } = groupsWith([row('b', false)]);
    await groups.look();
    const [group] = groups.groups.value;
    const first = groups.search(group!);
    groups.stopSearch();
    await first;
    expect(groups.hintOf(group!)).toBeUndefined();
    await groups.search(group!);
    await vi.waitFor(() => expect(searched).toHaveLength(1));
  });

  it('end a search with its worker, also one that was stopped and begun again before it had one', async () => {
    const { groups, searched } = groupsWith([row('b', false)]);
    await groups.look();
    const [group] = groups.groups.value;
    const first = groups.search(group!);
    groups.stopSearch();
    await Promise.all([first, groups.search(group!)]);
    expect(searched).toHaveLength(1);
    expect(groups.hintOf(group!)).toMatchObject({ holds: 1 });
  });

  it('forget a hint with the programs and the task that it was to', async () => {
    const { groups, model, searched } = groupsWith([row('b', false)]);
    await groups.look();
    const [group] = groups.groups.value;
    await groups.search(group!);
    model.rows.value = [row('b', false)];
    await groups.look();
    const [again] = groups.groups.value;
    expect([again!.key, groups.hintOf(again!)]).toEqual([group!.key, undefined]);
    await groups.search(again!);
    expect(searched).toHaveLength(2);
    model.task.value = { ...model.task.value };
    expect(groups.hintOf(again!)).toBeUndefined();
  });

  it('search no hint where only a hidden world was not passed', async () => {
    const { groups, model, searched } = groupsWith([row('b', false)]);
    const { task } = model.task.value;
    const hidden = { ...task.worlds[0], id: 'h', hidden: true };
    model.task.value = { ...model.task.value, task: { ...task, worlds: [task.worlds[0], hidden] } };
    await groups.look();
    await groups.search({ ...groups.groups.value[0]!, world: 'h' });
    expect(searched).toEqual([]);
  });

  it('wait for no run where there is no program', () => {
    const { groups } = groupsWith([{ ...row('b', false), handIn: null }]);
    expect(groups.waiting.value).toBe(0);
  });
});

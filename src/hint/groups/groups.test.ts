import { describe, expect, it } from 'vitest';
import { check } from '#check/check';
import { handInOfFiles } from '#check/hand-in/read-hand-in';
import { unreadable, type CheckResult, type Reason, type WorldResult } from '#check/result';
import { ahead, firmware, readyScene, readySolution, sceneWith, targetAt, taskWith } from '#check/testing/tasks';
import { plainWorld } from '#check/task/task';
import { LANGUAGES } from '#core/languages';
import type { Point } from '#scene/scene';
import type { Happened } from '../happened/happened';
import { groupHint, likewise } from './group-hint';
import { groupsOf, type ToGroup } from './groups';
import { factsOf, type RunFacts } from './run-facts';
import { groupFact, groupTitle, saidToClass } from './say';

const world = (more: Partial<WorldResult> = {}): WorldResult => ({
  ...{ id: 'visible', hidden: false, passed: false, reason: null, atMs: null, touches: 0, held: [], missed: {} },
  ...{ hash: '', trail: [], trailMs: [], ...more },
});
const result = (more: Partial<CheckResult> = {}): CheckResult => ({
  ...{ passed: false, points: 0, stars: null, checks: [], worlds: [world()], remarks: [], twin: '', ...more },
});
const failed = (name: string, happened: Happened, more: Partial<RunFacts> = {}): ToGroup => ({
  ...{ name, result: result() },
  facts: { world: 'visible', happened, at: [100, 100], next: null, departure: null, stays: false, bend: null, ...more },
});
const passed = (name: string, trail: readonly Point[] = [], atMs = 7100): ToGroup => ({
  ...{ name, facts: null },
  result: result({ passed: true, worlds: [world({ passed: true, atMs, trail: [trail] })] }),
});
const left = (name: string, atS: number, bend: number): ToGroup =>
  failed(name, { fact: 'left-line', atS }, { departure: { atS, bend, manner: 'late' } });
const SIZE: Point = [1200, 900];
const said = (all: readonly ToGroup[]): readonly string[] =>
  groupsOf(all, SIZE).map((group) => [groupTitle(group, 'en'), groupFact(group, 'visible', 'en'), group.members.join()].join(' | ')); // prettier-ignore

describe('groups of a class', () => {
  it('hold those together that failed in the same way at the same bend, whatever the time', () => {
    expect(said([left('a', 4.6, 2), left('b', 2, 1), left('c', 5.1, 2), passed('d'), passed('e', [], 9800)])).toEqual([
      '2 pass | in 7.1 to 9.8 s | d,e',
      '2 turn too late at bend 2 | line left at 4.6 to 5.1 s | a,c',
      '1 turns too late at bend 1 | line left at 2.0 s | b',
    ]);
  });

  it('tell the same at two places of the course apart', () => {
    const touches = (name: string, at: Point): ToGroup => failed(name, { fact: 'touched', atS: 2 }, { at });
    expect(said([touches('a', [100, 850]), touches('b', [1100, 100]), touches('c', [180, 800])])).toEqual([
      '2 touch something, top left | at 2.0 s | a,c',
      '1 touches something, bottom right | at 2.0 s | b',
    ]);
  });

  it('tell those apart that pass on different sides, but only if there are such', () => {
    const over: readonly Point[] = [[100, 100], [600, 700], [1100, 100]]; // prettier-ignore
    const under: readonly Point[] = [[100, 700], [600, 100], [1100, 700]]; // prettier-ignore
    expect(said([passed('a', over), passed('b', over)])).toEqual(['2 pass | in 7.1 s | a,b']);
    expect(said([passed('a', over), passed('b', under), passed('c', over)])).toEqual([
      '2 pass, round on the left | in 7.1 s | a,c',
      '1 passes, round on the right | in 7.1 s | b',
    ]);
  });

  it('keep what cannot be read, and what is for another task, apart at the end', () => {
    const unread: ToGroup = { name: 'u', result: unreadable([], { code: 'zip', params: {} }), facts: null };
    const other: ToGroup = {
      name: 'o',
      result: result({ remarks: [{ code: 'other-task', params: {} }] }),
      facts: null,
    };
    expect(said([unread, other, failed('a', { fact: 'unmoved' })])).toEqual([
      '1 never starts |  | a',
      '1 belongs to another task |  | o',
      '1 cannot be read |  | u',
    ]);
  });

  it('say of what could not be looked at just that, and why', () => {
    const lost: ToGroup = {
      ...failed('b', { fact: 'unmoved' }),
      facts: null,
      unseen: { code: 'unloaded', params: {} },
    };
    const unchecked: ToGroup = { name: 'c', result: unreadable([], { code: 'unloaded', params: {} }), facts: null };
    expect(said([lost, unchecked, failed('a', { fact: 'unmoved' })])).toEqual([
      '1 never starts |  | a',
      '2 could not be looked at | A part of Parcours does not load. Check the connection and try again. | b,c',
    ]);
  });

  it('are never more than ten: the smallest become one, and each hand-in is in one of them', () => {
    const all = Array.from({ length: 30 }, (_, place) => left(`n${place}`, 3, Math.min(place, 20)));
    const groups = groupsOf(all, SIZE);
    expect(groups).toHaveLength(10);
    expect(groups.at(-1)?.is.kind).toBe('others');
    expect(groups.flatMap(({ members }) => members).toSorted()).toEqual(all.map(({ name }) => name).toSorted());
    expect(new Set(groups.map(({ key }) => key)).size).toBe(10);
  });

  it('have the hand-in in the middle of their times as example, and one title in each language', () => {
    const [group] = groupsOf([left('a', 4.6, 2), left('b', 5.1, 2), left('c', 4.8, 2)], SIZE);
    expect(group?.example).toBe('c');
    for (const language of LANGUAGES) expect(groupTitle(group!, language)).toMatch(/^3 .*2/);
  });
});

describe('a group', () => {
  const reason = (name: string, params: Reason['params']): ToGroup =>
    failed(name, { fact: 'reason', reason: { code: 'stay', params } });

  it('gives the reason of all, if it is the same of all', () => {
    expect(said([reason('a', { seconds: 2, found: 1 }), reason('b', { seconds: 2, found: 1 })])).toEqual([
      expect.stringMatching(/ \| The robot was in the zone for 1 s.* \| a,b$/),
    ]);
    expect(said([reason('a', { seconds: 2, found: 1 }), reason('b', { seconds: 2, found: 0.5 })])).toEqual([
      expect.stringMatching(/ \|  \| a,b$/),
    ]);
  });

  it('is none of hand-ins that miss two checks of the same kind', () => {
    expect(groupsOf([reason('a', { seconds: 2, found: 1 }), reason('b', { seconds: 9, found: 1 })], SIZE)).toHaveLength(
      2,
    );
    const slow = (name: string, seconds: number): ToGroup => failed(name, { fact: 'slow', seconds });
    expect(groupsOf([slow('a', 5), slow('b', 9)], SIZE)).toHaveLength(2);
  });

  it('keeps its key while others join it, here or elsewhere on the course', () => {
    const touches = (name: string, at: Point): ToGroup => failed(name, { fact: 'touched', atS: 2 }, { at });
    const all = [touches('a', [100, 850]), touches('b', [140, 850]), touches('c', [1100, 100])];
    const keys = [1, 2, 3].map((count) => groupsOf(all.slice(0, count), SIZE)[0]?.key);
    expect(new Set(keys).size).toBe(1);
  });

  it('says to the class nothing of a hidden world, and is drawn in the one that pupils see', () => {
    const worlds = [plainWorld, { ...plainWorld, id: 'night', hidden: true }] as const;
    const touches = (name: string, at: Point): ToGroup =>
      failed(name, { fact: 'touched', atS: 2 }, { at, world: 'night' });
    const [group] = groupsOf([touches('a', [100, 850]), touches('b', [1100, 100])], SIZE);
    expect([groupTitle(group!, 'en'), groupFact(group!, 'visible', 'en')].join(' | ')).toBe(
      '1 touches something, top left | at 2.0 s · world night',
    );
    expect(saidToClass(group!, { worlds }, 'en')).toEqual({
      ...{ title: '1 touches something', fact: '' },
      group: { ...group, world: null, place: null, region: null },
    });
  });
});

describe('the facts of a run', () => {
  const task = taskWith(readyScene('corners'), { seconds: 30 });
  const solution = readySolution('corners');
  const handIn = (text: string) => handInOfFiles([{ name: 'main.py', text }]);
  const facts = async (text: string): Promise<RunFacts | null> => {
    const of = handIn(text);
    return factsOf(task, of, await check(task, of, { firmware: firmware() }), { firmware: firmware() });
  };

  it('are the bend at which the line was left, and how', { timeout: 60_000 }, async () => {
    const wrong = solution.replace('TO_WHEELS = 370', 'TO_WHEELS = 3700');
    expect(await facts(wrong)).toMatchObject({ departure: { bend: 1, manner: 'straight' } });
    expect(await facts('from mbrobot_plusV2 import *\nstop()\n')).toMatchObject({ happened: { fact: 'unmoved' } });
  });

  it('are none of a run that passes', { timeout: 60_000 }, async () => expect(await facts(solution)).toBeNull());

  it('lead to a hint that is tried out in the programs of the group', { timeout: 60_000 }, async () => {
    const near = taskWith(sceneWith([targetAt(420, 450)], { task: { ...sceneWith([]).task, seconds: 8 } }));
    const wrong = [400, 300].map((ms) => handIn(ahead(ms)));
    const found = await groupHint(near, [...wrong, handIn('x = 1\n')], { firmware: firmware(), budget: 100 });
    expect(found).toMatchObject({ holds: 2, of: 3, hint: { change: { kind: 'number', direction: 'more' } } });
    expect(found?.changes).toMatchObject([{ before: ['delay(400)'] }, { before: ['delay(300)'] }, null]);
  });
});

describe('the same change in another program', () => {
  const change = { kind: 'number', line: 2, before: ['    turn(0.4)'], after: ['    turn(0.1)'], direction: 'less' } as const; // prettier-ignore

  it('stands where the line is the same but for its numbers and its indentation', () => {
    expect(likewise(change, 'x()\n    turn(0.4)\n', 'a()\nb()\nturn(0.35)  # bend\n')).toEqual([
      { ...change, line: 3, before: ['turn(0.35)  # bend'], after: ['turn(0.1)  # bend'] },
    ]);
    expect(likewise(change, 'x()\n    turn(0.4)\n', 'spin(0.4)\n')).toEqual([]);
  });

  const number = (line: string, after: string, direction: 'more' | 'less') =>
    ({ kind: 'number', line: 1, before: [line], after: [after], direction }) as const;

  it('changes the one number alone that the change is about, and keeps the others as they are there', () => {
    const faster = number('drive(400, 20)', 'drive(800, 20)', 'more');
    expect(likewise(faster, 'drive(400, 20)\n', 'drive(500, 55)\n')).toEqual([
      number('drive(500, 55)', 'drive(800, 55)', 'more'),
    ]);
  });

  it('says whether the number becomes greater or less there, not in the example', () => {
    const longer = number('delay(2000)', 'delay(2300)', 'more');
    expect(likewise(longer, 'delay(2000)\n', 'delay(2600)\n')).toEqual([number('delay(2600)', 'delay(2300)', 'less')]);
    expect(likewise(longer, 'delay(2000)\n', 'delay(-5)\ndelay(2300)\n')).toEqual([]);
  });

  it('takes no name for another because of its number', () => {
    const faster = number('motor1(40)', 'motor1(80)', 'more');
    expect(likewise(faster, 'motor1(40)\n', 'motor2(40)\n')).toEqual([]);
  });
});

import { describe, expect, it } from 'vitest';

import { defaultScene, type Scene, type SceneObject, type Task, type Zone } from '#scene/scene';
import type { Verdict } from '#simulation/task/verdict';

import { goalsInWords, rulesInWords } from './goals';

const zone = (type: Zone['type'], number = 0, blocks = 0): Zone => ({
  ...{ type, id: `${type}-${String(number)}`, at: [100, 100], size: [50, 50], angle: 0, round: false },
  ...{ number, blocks },
});
const course = (objects: readonly SceneObject[], task: Partial<Task> = {}): Scene => ({
  ...defaultScene(),
  objects,
  task: { seconds: null, noTouch: false, ...task },
});
const verdict = (part: Partial<Verdict>): Verdict => ({
  ...{ state: 'open', atMs: null, reason: null, by: null, place: null, help: [], early: null, stars: null, touches: 0 },
  ...{ checkpoints: { passed: 0, of: 0 }, targets: { reached: 0, of: 0 }, blocks: { delivered: 0, of: 0 } },
  robots: [],
  ...part,
});
const said = (scene: Scene) => goalsInWords(scene, null).map(({ words }) => words);
const rules = (scene: Scene, now: Verdict | null = null) =>
  rulesInWords(scene, now).map(({ words, isBroken }) => (isBroken ? `${words}!` : words));

describe('the goals in words', () => {
  it('are made from the course, in the order in which they are done', () => {
    const three = [3, 1, 2].map((number) => zone('checkpoint', number));
    expect(goalsInWords(course([zone('target'), ...three]), null)).toEqual([
      { words: 'checkpointsInOrder', values: { first: 1, last: 3, count: 3 }, done: 0, of: 3 },
      { words: 'thenTarget', values: { count: 1 }, done: 0, of: 1 },
    ]);
  });

  it('say one and many differently, and whether there is an order', () => {
    expect(said(course([zone('checkpoint', 1)]))).toEqual(['checkpoint']);
    expect(said(course([zone('checkpoint', 1), zone('checkpoint', 1)]))).toEqual(['checkpointsAny']);
    expect(said(course([zone('target')]))).toEqual(['target']);
    expect(said(course([zone('target'), zone('target')]))).toEqual(['targets']);
    expect(said(course([zone('target', 0, 1)]))).toEqual(['block']);
    expect(said(course([zone('target', 0, 3), zone('target')]))).toEqual(['blocks', 'target']);
  });

  it('are to hold out where there is only a time', () => {
    const scene = course([], { seconds: 30 });
    expect(said(scene)).toEqual(['holdOut']);
    expect(rules(scene)).toEqual(['ownHands']);
    expect(goalsInWords(scene, verdict({ state: 'passed' }))[0]).toMatchObject({ done: 1, of: 1 });
  });

  it('count what is done while the robot drives', () => {
    const scene = course([zone('checkpoint', 1), zone('checkpoint', 2)]);
    const now = verdict({ checkpoints: { passed: 1, of: 2 } });
    expect(goalsInWords(scene, now)[0]).toMatchObject({ done: 1, of: 2 });
  });

  it('count for all of several robots', () => {
    const scene = course([zone('target')], { robots: 'all' });
    const now = verdict({ targets: { reached: 1, of: 3 } });
    expect(goalsInWords(scene, now)).toEqual([{ words: 'target', values: { count: 1 }, done: 1, of: 3 }]);
    expect(rules(scene)).toEqual(['all', 'ownHands']);
  });

  it('are to stay in the ring, which is no place to come to, or to catch the others', () => {
    const ring = course([zone('target')], { robots: 'ring', seconds: 60 });
    expect([said(ring), rules(ring)]).toEqual([['ring'], ['seconds', 'ownHands']]);
    expect(goalsInWords(ring, verdict({ state: 'passed' }))[0]).toMatchObject({ done: 1, of: 1 });
    expect(said(course([], { robots: 'catch' }))).toEqual(['catch']);
  });

  it('are none in an arena without a task', () => {
    expect([said(course([])), rules(course([]))]).toEqual([[], []]);
  });
});

describe('the rules in words', () => {
  const spikes: SceneObject = { type: 'spikes', id: 's', at: [9, 9], size: [50, 50], angle: 0 };
  const scene = course([zone('target'), zone('forbidden'), spikes], { seconds: 60 });

  it('are those of the course; that nothing may be touched includes spikes', () => {
    expect(rules(scene)).toEqual(['seconds', 'forbidden', 'spikes', 'ownHands']);
    expect(rules({ ...scene, task: { seconds: null, noTouch: true } })).toEqual(['noTouch', 'forbidden', 'ownHands']);
  });

  it('say what help is allowed', () => {
    expect(rules(course([zone('target')], { allows: ['hand', 'edits'] }))).toEqual(['handMayHelp', 'editsMayHelp']);
  });

  it('show the one that was broken', () => {
    expect(rules(scene, verdict({ state: 'failed', reason: 'time' }))).toContain('seconds!');
    expect(rules(scene, verdict({ state: 'failed', reason: 'forbidden' }))).toContain('forbidden!');
    expect(rules(scene, verdict({ state: 'helped', help: ['hand'] }))).toContain('ownHands!');
  });
});

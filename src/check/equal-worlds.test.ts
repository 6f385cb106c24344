import { describe, expect, it } from 'vitest';
import type { Carried } from '#project/project';
import { equalWorlds } from './equal-worlds';
import { equalTexts } from './report/say';
import { ahead, checked, sceneWith, targetAt, taskWith } from './testing/tasks';

const scene = sceneWith([targetAt(700, 450), targetAt(900, 800, 'far')], { task: { seconds: null, noTouch: false } });
const near = { start: { at: [220, 450], heading: 3 } };

/** The remarks on these hidden worlds, when the model solution drives ahead. */
async function told(worlds: readonly object[], program = ahead(4000)) {
  const data: Carried = {
    worlds,
    checks: [
      { type: 'touches', most: 3 },
      { type: 'stop', seconds: 1, zone: 't' },
    ],
  };
  const task = taskWith(scene, data);
  return equalWorlds(task, await checked(task, program));
}

describe('a hidden world', () => {
  it('is reported once if it comes out the same as another one', async () => {
    const worlds = [
      { id: '2', seed: 1 },
      { id: '3', ...near },
      { id: '4', seed: 9 },
      { id: '5', ...near },
    ];
    expect(await told(worlds, ahead(3000))).toEqual([
      { id: '2', other: '1' },
      { id: '4', other: '1' },
      { id: '5', other: '3' },
    ]);
  });

  it.each([
    ['another start', near],
    ['a used robot', { reality: 0.2, seed: 1 }],
    ['a sensor', { sensors: { lightLevel: 10 } }],
    ['a button', { inputs: [{ timeUs: 0, action: { type: 'button', button: 'a', down: true } }] }],
  ])('with %s hides something', async (_, world) => {
    expect(await told([{ id: '2', ...world }], ahead(3000))).toEqual([]);
  });

  it('is not told while the solution fails: nobody knows what it would do', async () => {
    expect(await told([{ id: '2' }], 'x = 1')).toEqual([]);
  });

  it('is told with the way out', () => {
    expect(equalTexts([{ id: '2', other: '1' }], 'en')).toEqual([
      'World 2 comes out the same as world 1: change start, wear or an object.',
    ]);
  });
});

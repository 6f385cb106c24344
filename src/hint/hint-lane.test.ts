import { describe, expect, it } from 'vitest';
import { handInOfFiles } from '#check/hand-in/read-hand-in';
import { STUCK_MS, type Answer } from '#check/lane';
import { sceneWith, targetAt, taskWith } from '#check/testing/tasks';
import type { Hint } from './hint';
import { HintLane, type HintRequest } from './hint-lane';

const task = taskWith(sceneWith([targetAt(700, 450)]));
const handIn = handInOfFiles([{ name: 'main.py', text: 'x = 1\n' }]);
const hint: Hint = {
  ...{
    reason: { code: 'open', params: {} },
    world: null,
    atMs: null,
    moment: null,
    tried: 6,
    program: 'x = 1\n',
    change: null,
  },
  happened: { fact: 'unmoved' },
};

/** A lane whose threads answer nothing to a budget above `most`, and are at this place then. */
function laneWith(most: number, world: number) {
  const budgets: number[] = [];
  const watching = new Set<() => void>();
  const start = (heard: (answer: Answer<Hint | null>) => void) => ({
    ask: ({ budget }: HintRequest) => {
      budgets.push(budget);
      if (budget <= most) queueMicrotask(() => heard({ result: { ...hint, tried: budget } }));
    },
    pulse: () => ({ beat: 0, world }),
    stop: () => undefined,
  });
  const lane = new HintLane(task, start, (_, act) => {
    watching.add(act);
    return () => watching.delete(act);
  });
  const pass = async (): Promise<void> => {
    for (let round = 0; round < 2; round += 1) {
      for (let look = 0; look <= STUCK_MS / 200 + 1; look += 1) for (const act of watching) act();
      await new Promise((resolve) => setTimeout(resolve));
    }
  };
  return { lane, budgets, pass };
}

describe('a lane for hints', () => {
  it('says that a program never comes out of a call', async () => {
    const { lane, pass } = laneWith(-1, 0);
    const found = lane.hint(handIn, 400);
    await pass();
    expect(await found).toMatchObject({ reason: { code: 'stuck' }, happened: { fact: 'stuck' }, tried: 0 });
  });

  it('takes what came before a try that never comes out of one', async () => {
    const { lane, budgets, pass } = laneWith(6, 1 + 7);
    const found = lane.hint(handIn, 400);
    await pass();
    expect(await found).toMatchObject({ happened: { fact: 'unmoved' }, tried: 6 });
    expect(budgets).toEqual([400, 400, 6]);
  });
});

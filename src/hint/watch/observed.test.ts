import { describe, expect, it } from 'vitest';
import { handInOfFiles } from '#check/hand-in/read-hand-in';
import { runWorld, type Onlooker } from '#check/run/run-world';
import { firmware, sceneWith, targetAt, taskWith } from '#check/testing/tasks';
import type { Simulation } from '#simulation/simulation';
import { Observed } from './observed';

const task = taskWith(sceneWith([targetAt(1100, 100)]), { seconds: 20 });
const TEXT = 'from mbrobot import *\nfor i in range(150):\n    delay(100)\nforward()\ndelay(1000)\nstop()\n';

/** Looks at a program, with less care from a moment on. */
async function seenWith(lessFromUs: number): Promise<{ readonly seen: Observed; readonly hash: string }> {
  const seen = new Observed();
  const onlooker: Onlooker = {
    hasEnough: false,
    look(run: Simulation) {
      seen.look(run);
      if (run.nowUs === lessFromUs) seen.noteLess(run, 6);
    },
  };
  const { project } = handInOfFiles([{ name: 'main.py', text: TEXT }]);
  const { hash } = await runWorld(task, project, task.worlds[0], { firmware: firmware(), beat: () => undefined, onlooker }); // prettier-ignore
  return { seen, hash };
}

describe('a run in which nothing new happens', () => {
  it('is looked at less closely, and neither a line that begins later nor the way of the robot is missed', async () => {
    const [all, less] = [await seenWith(-1), await seenWith(5_000_000)];
    expect([...less.seen.lastRanUs.keys()].sort()).toEqual([...all.seen.lastRanUs.keys()].sort());
    expect(less.seen.lastRanUs.get(4)! / 1e6).toBeCloseTo(all.seen.lastRanUs.get(4)! / 1e6, 2);
    expect(less.seen.lastRanUs.get(3)).toBeLessThan(6_000_000);
    const way = ({ seen }: typeof all) => seen.moments.map(({ timeUs, pose }) => ({ timeUs, pose }));
    expect(way(less)).toEqual(way(all));
    expect(less.hash).toBe(all.hash);
  });
});

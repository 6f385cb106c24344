import type { Scene } from '#scene/scene';
import { briefOf } from './task-brief';
import type { Verdict } from './verdict';

/** The verdict before the start. */
export function verdictAtStart(scene: Pick<Scene, 'task' | 'objects' | 'league'>): Verdict {
  const { checkpoints, robotTargets, blocksWanted } = briefOf(scene);
  return {
    state: 'open',
    atMs: null,
    reason: null,
    by: null,
    place: null,
    help: [],
    early: null,
    stars: null,
    checkpoints: { passed: 0, of: checkpoints.length },
    targets: { reached: 0, of: robotTargets.length },
    blocks: { delivered: 0, of: blocksWanted },
    touches: 0,
    robots: [],
  };
}

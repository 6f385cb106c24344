import { onScopeDispose, watch, type ShallowRef } from 'vue';

import type { Scene } from '#scene/scene';
import { movesBodies } from '#simulation/at-once';

import type { Hand } from '../../run/hand';
import type { RunModel } from '../../run/run-model';
import type { WorkModel } from './work-model';

/**
 * Sends each step of the course to the current run, as an input that can be replayed: an edit, or the inverse of one that
 * is undone. The run decides what takes effect at once and what at the next start. The hand lets go of what the course
 * has changed.
 *
 * @param runStart the run's initial course; cleared here when everything is back at the start
 */
export function useLiveEdits(
  run: Pick<RunModel, 'phase' | 'isActive' | 'present' | 'input' | 'reset'>,
  work: Pick<WorkModel, 'onStep'>,
  hand: Pick<Hand, 'letGo'>,
  runStart: ShallowRef<Scene | null>,
): void {
  watch(
    run.phase,
    (phase) => {
      if (phase === 'ready') runStart.value = null;
    },
    { flush: 'sync' },
  );
  const stop = work.onStep(({ type, step }) => {
    hand.letGo(step);
    if (run.isActive.value) {
      if (run.phase.value === 'stopping') return;
      run.input({ type: 'edit', edit: type === 'undo' ? step.inverse : step.edit });
      // The last picture of a stopped run would hide what was changed.
    } else if (run.present.value !== null && movesBodies(step)) void run.reset();
  });
  onScopeDispose(stop);
}

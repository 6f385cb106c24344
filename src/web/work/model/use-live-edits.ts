import { watch, type ShallowRef } from 'vue';

import { editBetween } from '#scene/edit-between';
import type { Scene } from '#scene/scene';

import type { RunModel } from '../../run/run-model';
import type { WorkModel } from './work-model';

/**
 * Sends changes of the course to the current run, as inputs that can be replayed: everything that was changed, undone
 * or redone since the last time. The run decides what takes effect at once and what at the next start.
 *
 * @param runStart the run's initial course; cleared here when everything is back at the start
 */
export function useLiveEdits(
  run: Pick<RunModel, 'phase' | 'isActive' | 'input'>,
  work: Pick<WorkModel, 'scene'>,
  runStart: ShallowRef<Scene | null>,
): void {
  let told: Scene | null = null;

  // At once: an edit belongs to the moment in which it was made.
  watch(
    run.phase,
    (phase, before) => {
      if (phase === 'ready') runStart.value = null;
      if (before !== 'starting') return;
      told = runStart.value;
      tell();
    },
    { flush: 'sync' },
  );
  watch(work.scene, tell, { flush: 'sync' });

  function tell(): void {
    // While it starts nobody listens yet; what is changed meanwhile is told as soon as somebody does.
    const { value: phase } = run.phase;
    if (told === null || !run.isActive.value || phase === 'starting' || phase === 'stopping') return;
    const edit = editBetween(told, work.scene.value);
    told = work.scene.value;
    if (edit !== null) run.input({ type: 'edit', edit });
  }
}

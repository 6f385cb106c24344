import { watch } from 'vue';

import type { Refusal } from '#embed/simulator';

import type { RunParts } from '../../session/run/parts';
import type { VisitParts } from '../../session/visit/parts';

/**
 * Starts the program, also while a run is under way.
 *
 * @param paused whether it starts paused
 * @returns `null` when the run is under way; otherwise why it did not begin
 */
export function startRun({ run, host }: Pick<RunParts, 'run'> & VisitParts, paused: boolean): Promise<Refusal> {
  return new Promise((resolve) => {
    let failure = 'The run could not start.';
    const unlisten = host.listen((event) => {
      if (event.type === 'failed') failure = event.message;
    });
    // Watched from before the start, because a listener of the start may stop the run at once.
    const unwatch = watch(
      run.phase,
      (phase) => {
        if (phase === 'starting') return;
        unwatch();
        // The event of a failure comes right after its phase.
        queueMicrotask(() => {
          unlisten();
          if (phase === 'running' || phase === 'paused') resolve(null);
          else resolve(phase === 'failed' || phase === 'killed' ? failure : STOPPED);
        });
      },
      { flush: 'sync' },
    );
    void run.start(paused);
  });
}

const STOPPED = 'The run was stopped before it began.';

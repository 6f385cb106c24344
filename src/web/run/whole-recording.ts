import { watch } from 'vue';

import type { Recording } from './recording';
import type { RunModel } from './run-model';

/**
 * Looks back, and waits for the newest moments of the run and all that was done to it: of a run that goes on, they come a
 * moment later.
 *
 * @returns the recording; `null`: the run is gone, or was never recorded
 */
export async function wholeRecording(run: RunModel): Promise<Recording | null> {
  const recording = run.recording.value;
  if (run.isActive.value) {
    const come = new Promise<void>((resolve) => {
      const stop = watch([recording.inputs, run.recording, run.isActive], () => {
        stop();
        resolve();
      });
    });
    run.lookBack();
    await come;
  }
  const isWhole = recording.canGoOn && run.recording.value === recording;
  return isWhole ? recording : null;
}

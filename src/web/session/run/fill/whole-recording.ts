import { watch } from 'vue';

import { fillInSilently } from './fill-in';
import type { Recording } from '../recording';
import type { RunModel } from '../run-model';

/**
 * Fetches the recording of the run. For a run in progress it starts looking back, and waits for the newest moments and
 * all inputs, which arrive a moment later.
 *
 * @param wants `all moments`: also those that a run at full speed has left out, which may take seconds
 * @returns the recording; `null`: the run is gone, or was never recorded
 */
export async function wholeRecording(run: RunModel, wants: 'all moments' | 'the inputs'): Promise<Recording | null> {
  const recording = run.recording.value;
  if (run.isActive.value) {
    const come = new Promise<void>((resolve) => {
      const stop = watch([recording.inputs, run.recording, run.isActive], () => {
        stop();
        resolve();
      });
    });
    run.look.back();
    await come;
  }
  if (wants === 'all moments') await fillInSilently(recording, run);
  const isWhole = recording.canRepeat && run.recording.value === recording;
  return isWhole ? recording : null;
}

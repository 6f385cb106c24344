import { watch } from 'vue';

import type { EmbeddedDebugger } from '#embed/debugger';
import type { Refusal } from '#embed/simulator';

import type { RunParts } from '../../session/run/parts';
import { RecordedRows } from '../../session/run/recorded-rows';
import { goOn } from '../../session/run/run-again';
import { wholeRecording } from '../../session/run/fill/whole-recording';

/** The past of the run, for a host: the page may show it without its time line. */
export function hostPast({
  run,
}: Pick<RunParts, 'run'>): Pick<EmbeddedDebugger, 'lookAt' | 'lookNow' | 'goOn' | 'isLookingBack'> {
  const recorded = new RecordedRows();
  return {
    async lookAt(timeUs) {
      const { phase } = run;
      if (phase.value === 'starting' || phase.value === 'stopping') return `This needs a run that has been; it is ${phase.value}.`; // prettier-ignore
      const endUs = run.present.value?.timeUs ?? -1;
      if (endUs >= 0 && timeUs > endUs)
        return `The run has come to ${endUs / 1000} ms; there is no moment at ${timeUs / 1000} ms.`;
      const recording = await wholeRecording(run, 'all moments');
      const moment = recording && recorded.of(recording).at(timeUs);
      if (moment === null) return 'This needs a run that has been.';
      run.look.at(timeUs, moment);
      return null;
    },
    lookNow() {
      run.look.leave();
      return null;
    },
    async goOn(paused) {
      if (run.past.value === null) return 'This needs a moment of the past: look-at chooses one.';
      const { timeUs } = run.past.value;
      if ((await wholeRecording(run, 'the inputs')) === null) return 'This run cannot be run again.';
      const there = isThere(run);
      await goOn(run, timeUs, paused);
      return there;
    },
    isLookingBack: () => run.past.value !== null,
  };
}

/** Resolves when the run is at the moment from which it goes on, or says why it does not come there. */
function isThere(run: RunParts['run']): Promise<Refusal> {
  return new Promise((resolve) => {
    const end = watch([run.phase, run.past], ([phase, past]) => {
      if (phase === 'starting' || (past !== null && run.isActive.value)) return;
      end();
      resolve(run.isActive.value ? null : 'The run was stopped before it was there.');
    });
  });
}

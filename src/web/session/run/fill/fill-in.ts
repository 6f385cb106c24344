import { watch } from 'vue';

import { fillGap, gapIn, type Gap } from './gap';
import type { Recording } from '../recording';
import { repeatInWorker, type Repeated, type RepeatWish } from '../repeat-client';
import type { RunModel } from '../run-model';

/** Runs a run again. @returns `null`: it was given up */
type Repeat = (wish: RepeatWish) => Promise<Repeated | null>;

/**
 * Adds the moments missing from a tape, by repeating the run. Further calls in the meantime wait for the same work; if
 * it is impossible, or was given up, the tape is left as it is.
 */
export function fillIn(recording: Recording, repeat: Repeat): Promise<void> {
  return (recording.filling ??= fillGaps(recording, repeat).finally(() => (recording.filling = null)));
}

async function fillGaps(recording: Recording, repeat: Repeat): Promise<void> {
  try {
    for (let gap = gapIn(recording); gap && gap.untilUs !== recording.givenUpUs; gap = gapIn(recording)) {
      const wish = wishFor(recording, gap);
      const repeated = wish && (await repeat(wish));
      if (repeated === null) recording.givenUpUs = gap.untilUs;
      else fillGap(recording, gap, repeated.pieces);
    }
  } catch {
    // The VM could not be loaded: the existing part of the tape is shown.
  }
}

function wishFor({ setup, inputs: { value: inputs } }: Recording, { sinceUs, untilUs }: Gap): RepeatWish | null {
  if (setup === null || inputs === null) return null;
  return { setup: { ...setup, inputs }, untilUs, untilProgramEnds: false, momentsSinceUs: sinceUs };
}

/** Adds the missing moments without showing the progress. */
export const fillInSilently = (recording: Recording, { engine }: Pick<RunModel, 'engine'>): Promise<void> =>
  fillIn(recording, (wish) => repeatInWorker(engine, wish, () => undefined, new AbortController().signal));

/** For the component's life, fills in the tape whenever all inputs to its run have been reported. */
export function useFilled(recording: () => Recording | null, fill: (recording: Recording) => Promise<void>): void {
  watch(
    [recording, () => recording()?.inputs.value],
    ([now]) => {
      if (now !== null && gapIn(now) !== null) void fill(now);
    },
    { immediate: true },
  );
}

import type { RunSetup } from '#simulation/run-setup';
import type { Snapshot } from '#simulation/snapshot';
import type { BroughtTape } from './recording';
import type { RunModel } from './run-model';

/**
 * Continues the run from one of its moments: it is repeated up to there, with all its inputs until then, as fast as
 * possible.
 *
 * @param paused whether it is paused there at first
 */
export function goOn(run: RunModel, fromUs: number, paused = false): Promise<void> {
  const { setup, inputs } = run.recording.value;
  if (setup === null || inputs.value === null) return Promise.resolve();
  const kept = { ...setup, inputs: inputs.value.filter(({ timeUs }) => timeUs <= fromUs) };
  const shown = fromUs > 0 ? run.past.value : null;
  return run.begin({ kept, paused, catchUpUs: fromUs, left: run.recording.value, shown });
}

/** A recorded run, and the moment to show. */
export interface RunAgain {
  readonly kept: RunSetup;
  readonly untilUs: number;
  readonly ends: BroughtTape['ends'];
  /** Its first picture. */
  readonly first: Snapshot;
  /** All of its moments, up to `untilUs`. */
  readonly pieces: readonly Uint8Array[];
  /** The moment at which looking back starts. */
  readonly atUs: number;
}

/**
 * Looks back at a moment of a recorded run. In the meantime the run is repeated as fast as possible and paused at its
 * end, from where it could continue.
 */
export function showAgain(run: RunModel, { kept, first, atUs, ...tape }: RunAgain): Promise<void> {
  const { untilUs } = tape;
  const asked = { timeUs: Math.min(atUs, untilUs), ...(atUs === 0 && { exact: first }) };
  return run.begin({ kept, paused: true, catchUpUs: Math.max(untilUs, 1), brought: tape, shown: first, asked });
}

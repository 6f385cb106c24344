import type { RunSetup } from '#simulation/run-setup';
import type { Snapshot } from '#simulation/snapshot';
import type { BroughtTape } from './recording';
import type { RunModel } from './run-model';

/**
 * The run goes on from one of its moments: it is run again up to there, with all that was done until then, as fast as
 * it can.
 *
 * @param paused whether it stands there at first
 */
export function goOn(run: RunModel, fromUs: number, paused = false): Promise<void> {
  const { setup, inputs } = run.recording.value;
  if (setup === null || inputs.value === null) return Promise.resolve();
  const kept = { ...setup, inputs: inputs.value.filter(({ timeUs }) => timeUs <= fromUs) };
  const shown = fromUs > 0 ? run.past.value : null;
  return run.begin({ kept, paused, catchUpUs: fromUs, left: run.recording.value, shown });
}

/** A run that was kept, and how it is looked at. */
export interface RunAgain {
  readonly kept: RunSetup;
  readonly untilUs: number;
  readonly ends: BroughtTape['ends'];
  /** What it showed at its beginning. */
  readonly first: Snapshot;
  /** All of its moments, up to `untilUs`. */
  readonly pieces: readonly Uint8Array[];
  /** The moment from which it is looked at. */
  readonly atUs: number;
}

/**
 * A run that was kept is looked back at from a moment. Meanwhile it is run again as fast as it can, and stands still at its
 * end: from there it could go on.
 */
export function showAgain(run: RunModel, { kept, first, atUs, ...tape }: RunAgain): Promise<void> {
  const { untilUs } = tape;
  const asked = { timeUs: Math.min(atUs, untilUs), ...(atUs === 0 && { exact: first }) };
  return run.begin({ kept, paused: true, catchUpUs: Math.max(untilUs, 1), brought: tape, shown: first, asked });
}

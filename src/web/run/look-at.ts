import type { Snapshot } from '#simulation/snapshot';
import type { RunModel } from './run-model';

/** Looks back at a moment of the run. @param exact the moment itself, where it is known better than on the tape */
export function lookAt(run: Pick<RunModel, 'lookBack' | 'recording'>, timeUs: number, exact?: Snapshot): void {
  run.lookBack();
  run.recording.value.asked.value = { timeUs, ...(exact && { exact }) };
}

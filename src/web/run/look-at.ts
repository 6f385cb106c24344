import type { RunModel } from './run-model';

/** Looks back at a moment of the run. */
export function lookAt(run: Pick<RunModel, 'lookBack' | 'recording'>, timeUs: number): void {
  run.lookBack();
  run.recording.value.asked.value = { timeUs };
}

import { stillness } from '#check/run/stillness';
import type { Simulation } from '#simulation/simulation';

/** When a run ends. */
export interface RunEnd {
  /** Simulated time at which it ends; with the others it may end sooner. */
  readonly untilUs: number;
  /** True: it ends with its programs. */
  readonly untilProgramEnds: boolean;
  /** True: it ends when the course's task is decided, or when nothing more can happen. */
  readonly untilVerdict: boolean;
}

/** Simulated time between two looks at a run. Chosen: some ms of wall time, few suspensions of the program. */
export const SLICE_US = 100_000;

/**
 * The way of a run to its end, in slices: where it ends, and so its fingerprint, is the same whoever takes it there.
 *
 * @returns `isOver` also ends with the programs if they were interrupted
 */
export function runningTo(
  simulation: Simulation,
  { untilUs, untilProgramEnds, untilVerdict }: RunEnd,
): { readonly isOver: (isInterrupted?: boolean) => boolean; readonly advance: () => void } {
  const isStill = stillness(simulation);
  const hasEnded = (): boolean => simulation.hasEnded || simulation.isOff;
  const isDecided = (): boolean => simulation.isOff || isStill() || ![null, undefined, 'open'].includes(simulation.verdict?.state); // prettier-ignore
  return {
    isOver: (isInterrupted = false) =>
      simulation.nowUs >= untilUs ||
      (untilVerdict && isDecided()) ||
      (hasEnded() && (untilProgramEnds || isInterrupted)),
    advance: () => {
      const nextUs = Math.min(untilUs, simulation.nowUs + SLICE_US);
      if (untilProgramEnds) simulation.advanceProgramTo(nextUs);
      else simulation.advanceTo(nextUs);
    },
  };
}

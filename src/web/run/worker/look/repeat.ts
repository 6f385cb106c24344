/** Running a kept run again to its end, in a worker of its own: what it comes to is its proof. */
import type { RunSetup } from '#simulation/run-setup';
import { Simulation } from '#simulation/simulation';
import type { Snapshot } from '#simulation/snapshot';
import { OutputHashes, resultOf, type TapeResult } from '#tape/result';

/** Simulated time between two looks at the wall clock. Chosen: some ms of wall time, as on the command line. */
const PIECE_US = 100_000;
/** Wall time between two messages, in ms. */
const TELL_MS = 100;

/** From the page: the run, and until when: this simulated time, or before it the end of all programs. */
export interface RepeatRequest {
  readonly type: 'repeat';
  readonly firmware: WebAssembly.Module;
  readonly setup: RunSetup;
  readonly untilUs: number;
  readonly untilProgramEnds: boolean;
}

/** What a run came to, and what it showed at its first moment. */
export interface Repeated {
  readonly result: TapeResult;
  readonly first: Snapshot;
}

/** To the page: how far it is, again and again; then one of the others. */
export type RepeatAnswer =
  | { readonly type: 'repeating'; readonly nowUs: number }
  | { readonly type: 'repeated'; readonly repeated: Repeated }
  | { readonly type: 'failed'; readonly message: string };

/** Answers a request; never rejects. Whoever has lost patience ends the worker. */
export async function answerRepeat(
  { firmware, setup, untilUs, untilProgramEnds }: RepeatRequest,
  at: { post(message: RepeatAnswer): void; nowMs(): number },
): Promise<void> {
  try {
    const output = new OutputHashes(setup.devices.length);
    const run = await Simulation.create(setup, firmware, { print: (text, device) => output.add(text, device) });
    const first = run.snapshot();
    const isOver = (): boolean => run.nowUs >= untilUs || (untilProgramEnds && (run.hasEnded || run.isOff));
    let toldMs = at.nowMs();
    while (!isOver()) {
      const nextUs = Math.min(untilUs, run.nowUs + PIECE_US);
      if (untilProgramEnds) run.advanceProgramTo(nextUs);
      else run.advanceTo(nextUs);
      if (at.nowMs() - toldMs < TELL_MS) continue;
      toldMs = at.nowMs();
      at.post({ type: 'repeating', nowUs: run.nowUs });
    }
    at.post({ type: 'repeated', repeated: { result: resultOf(run, output), first } });
  } catch (error) {
    at.post({ type: 'failed', message: error instanceof Error ? error.message : String(error) });
  }
}

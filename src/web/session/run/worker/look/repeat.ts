/** Repeats a recorded run to a time or its end, in a worker of its own. */
import type { RunOutlets } from '#simulation/outlets';
import type { RunSetup } from '#simulation/run-setup';
import { Simulation } from '#simulation/simulation';
import type { Snapshot } from '#simulation/snapshot';
import { RowWriter } from '#tape/rows/row-writer';
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
  /** The moments after this time are wanted, too; left out: none. −1: all. */
  readonly momentsSinceUs?: number;
}

/** Result of a run, and its first picture. */
export interface Repeated {
  readonly result: TapeResult;
  readonly first: Snapshot;
  /** The moments that were wanted: pieces for `Rows`, which need none before them. */
  readonly pieces: readonly Uint8Array[];
}

/** To the page: the simulated time reached, every `TELL_MS`; at the end one of the others. */
export type RepeatAnswer =
  | { readonly type: 'repeating'; readonly nowUs: number }
  | { readonly type: 'repeated'; readonly repeated: Repeated }
  | { readonly type: 'failed'; readonly message: string };

/** Answers a request; never rejects. To give up, end the worker. */
export async function answerRepeat(
  { firmware, setup, untilUs, untilProgramEnds, momentsSinceUs = Infinity }: RepeatRequest,
  at: { post(message: RepeatAnswer): void; nowMs(): number },
): Promise<void> {
  try {
    const output = new OutputHashes(setup.devices.length);
    const tape = takeMoments(momentsSinceUs);
    const print = (text: string, device: number): void => output.add(text, device);
    const run = await Simulation.create(setup, firmware, { print, ...tape.outlets });
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
    at.post({ type: 'repeated', repeated: { result: resultOf(run, output), first, pieces: tape.pieces() } });
  } catch (error) {
    at.post({ type: 'failed', message: error instanceof Error ? error.message : String(error) });
  }
}

/** Collects the moments after a time. */
function takeMoments(sinceUs: number) {
  const writer = new RowWriter();
  const pieces: Uint8Array[] = [];
  const keep = (piece: Uint8Array | null): void => {
    if (piece !== null) pieces.push(piece);
  };
  const outlets: RunOutlets = {
    isMomentWanted: (timeUs) => timeUs > sinceUs,
    moment: (snapshot) => keep(writer.add(snapshot)),
  };
  return {
    outlets,
    /** All pieces so far. */
    pieces(): readonly Uint8Array[] {
      keep(writer.finish());
      return pieces;
    },
  };
}

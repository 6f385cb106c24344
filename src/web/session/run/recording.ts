import { shallowRef, type ShallowRef } from 'vue';

import type { InputEvent } from '#simulation/input';
import type { RunSetup } from '#simulation/run-setup';
import type { Snapshot } from '#simulation/snapshot';
import type { WhyAsked } from './why-asked';
import type { FromWorker, Output } from './worker/protocol';

/** Maximum number of pieces of output in the recording. Chosen: a line every 20 ms for ten minutes and more. */
const MOST_OUTPUT = 40_000;

/** A requested moment. */
export interface Asked {
  readonly timeUs: number;
  /** The moment itself, where it is known better than on the tape. */
  readonly exact?: Snapshot;
}

/** All moments of a run up to a time. */
export interface BroughtTape {
  readonly pieces: readonly Uint8Array[];
  readonly untilUs: number;
  /** The end of the run according to its file. */
  readonly ends: { readonly untilUs: number; readonly untilProgramEnds: boolean };
}

/** The recording of a run: enough to show any of its moments again, and to repeat it up to one. */
export class Recording {
  /** Changes with each new piece of the tape, and when thin ones are replaced. */
  readonly count = shallowRef(0);
  /**
   * The pieces, packed as they arrived: they are unpacked only for looking back. A new list replaces it when thin
   * pieces were replaced: readers of the old one start over.
   */
  pieces: readonly Uint8Array[] = [];
  /** For each piece: the time from which moments are missing, because it is thin; `null`: none are missing. */
  thinSince: readonly (number | null)[] = [];
  /** Number of pieces, and their end, at the last report of all inputs to the run. */
  reported = { pieces: 0, untilUs: 0 };
  /** The output of the programs, oldest first, as it arrived; when there is too much, the oldest half is dropped. */
  output: readonly Output[] = [];
  /** The work of adding missing moments; `null`: none is in progress. */
  filling: Promise<void> | null = null;
  /** End of a gap whose moments were given up; `null`: none was. */
  givenUpUs: number | null = null;
  /** Number of pieces of output that were dropped. */
  outputGone = 0;
  private readonly asking: ShallowRef<Asked | null> = shallowRef(null);
  /** The requested moment, which the time line goes to. `null`: it has arrived there. */
  readonly asked: Readonly<ShallowRef<Asked | null>> = this.asking;
  private readonly question: ShallowRef<WhyAsked | null> = shallowRef(null);
  /** The pending question for a line; `null`: none. */
  readonly why: Readonly<ShallowRef<WhyAsked | null>> = this.question;
  /** All inputs to the run up to the last request for the tape; `null`: they were never reported. */
  readonly inputs: ShallowRef<readonly InputEvent[] | null> = shallowRef(null);
  private readonly leftRun: ShallowRef<Recording | null>;
  /** The run that this one branched off from, shown as a ghost; `null`: none, or it is hidden. */
  readonly ghost: Readonly<ShallowRef<Recording | null>>;

  /**
   * @param setup of the run; `null`: there is none
   * @param left the run that this one branched off from
   * @param brought the tape of a run recorded earlier, maybe elsewhere, which is shown from its beginning
   */
  constructor(
    readonly setup: RunSetup | null,
    left: Recording | null = null,
    private brought: BroughtTape | null = null,
  ) {
    this.ghost = this.leftRun = shallowRef(left);
    this.isBrought = brought !== null;
    this.broughtTape = brought;
    for (const piece of brought?.pieces ?? []) this.add(piece, null);
  }
  readonly isBrought: boolean;
  /** The tape of a run recorded earlier, also when it has been repeated; `null`: this is a new run. */
  readonly broughtTape: BroughtTape | null;

  /** True if the run can be run again. */
  get canRepeat(): boolean {
    return this.setup !== null && this.inputs.value !== null;
  }

  /** Requests a moment; `null`: it is there, or no longer wanted. */
  ask(moment: Asked | null): void {
    this.asking.value = moment;
  }

  /** Asks for the lines that caused something; `null`: the question is withdrawn. */
  askWhy(question: WhyAsked | null): void {
    this.question.value = question;
  }

  /** Hides the ghost of the run that was left. */
  hideGhost(): void {
    this.leftRun.value = null;
  }

  /** Handles the worker's messages about the tape. */
  hear(message: FromWorker): void {
    if (message.type === 'tape' && !this.brought) this.add(message.piece, message.thinSinceUs);
    if (message.type !== 'inputs') return;
    // Until here its moments were there before.
    if (this.brought && message.nowUs >= this.brought.untilUs) this.brought = null;
    this.reported = { pieces: this.pieces.length, untilUs: message.nowUs };
    this.inputs.value = message.inputs;
  }

  private add(piece: Uint8Array, thinSinceUs: number | null): void {
    (this.pieces as Uint8Array[]).push(piece);
    (this.thinSince as (number | null)[]).push(thinSinceUs);
    this.count.value += 1;
  }

  addOutput(output: Output): void {
    (this.output as Output[]).push(output);
    const gone = this.output.length > MOST_OUTPUT ? this.output.length - MOST_OUTPUT / 2 : 0;
    if (gone > 0) this.output = this.output.slice(gone);
    this.outputGone += gone;
  }
}

import { shallowRef, type ShallowRef } from 'vue';

import type { InputEvent } from '#simulation/input';
import type { RunSetup } from '#simulation/run-setup';
import type { Snapshot } from '#simulation/snapshot';
import type { WhyAsked } from './why-asked';
import type { FromWorker } from './worker/protocol';

import type { Output } from './worker/protocol';

/** Most pieces of output that are kept. Chosen: a line every 20 ms for ten minutes and more. */
const MOST_OUTPUT = 40_000;

/** A moment that is asked for. */
interface Asked {
  readonly timeUs: number;
  /** The moment itself, where it is known better than on the tape. */
  readonly exact?: Snapshot;
}

/** What is kept of a run: enough to show any of its moments again, and to run it again up to one. */
export class Recording {
  /** Number of pieces of the tape; changes with each that comes. */
  readonly count = shallowRef(0);
  /** The pieces, packed as they came: nothing is unpacked before somebody looks back. */
  readonly pieces: Uint8Array[] = [];
  /** What the programs have printed, oldest first, as it came; the oldest half goes when it is too much. */
  output: readonly Output[] = [];
  /** Pieces of output that are gone. */
  outputGone = 0;
  /** A moment that somebody has asked to see: the time line goes there. `null`: it is there. */
  readonly asked: ShallowRef<Asked | null> = shallowRef(null);
  /** What somebody wants to know the line of; `null`: nothing. */
  readonly why: ShallowRef<WhyAsked | null> = shallowRef(null);
  /** Everything done to the run up to when the tape was asked for last; `null`: it was never said. */
  readonly inputs: ShallowRef<readonly InputEvent[] | null> = shallowRef(null);
  /** The run that this one has left: what came there after the moment from which this one went on. `null`: none. */
  readonly ghost: ShallowRef<Recording | null>;

  /**
   * @param setup of the run; `null`: there is none
   * @param left the run that this one has left
   * @param isBrought it was recorded before, maybe by somebody else, and is looked at from its beginning on
   */
  constructor(
    readonly setup: RunSetup | null,
    left: Recording | null = null,
    readonly isBrought = false,
  ) {
    this.ghost = shallowRef(left);
  }

  /** The run can be run again. */
  get canGoOn(): boolean {
    return this.setup !== null && this.inputs.value !== null;
  }

  hear(message: Extract<FromWorker, { type: 'tape' | 'inputs' }>): void {
    if (message.type === 'inputs') this.inputs.value = message.inputs;
    else this.count.value = this.pieces.push(message.piece);
  }

  addOutput(output: Output): void {
    (this.output as Output[]).push(output);
    const gone = this.output.length > MOST_OUTPUT ? this.output.length - MOST_OUTPUT / 2 : 0;
    if (gone > 0) this.output = this.output.slice(gone);
    this.outputGone += gone;
  }
}

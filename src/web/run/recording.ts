import { shallowRef, type ShallowRef } from 'vue';

import type { InputEvent } from '#simulation/input';
import type { RunSetup } from '#simulation/run-setup';
import type { Snapshot } from '#simulation/snapshot';
import type { WhyAsked } from './why-asked';
import type { FromWorker, Output } from './worker/protocol';

/** Most pieces of output that are kept. Chosen: a line every 20 ms for ten minutes and more. */
const MOST_OUTPUT = 40_000;

/** A moment that is asked for. */
export interface Asked {
  readonly timeUs: number;
  /** The moment itself, where it is known better than on the tape. */
  readonly exact?: Snapshot;
}

/** All moments of a run up to a time. */
export interface BroughtTape {
  readonly pieces: readonly Uint8Array[];
  readonly untilUs: number;
  /** How its file says until when it goes. */
  readonly ends: { readonly untilUs: number; readonly untilProgramEnds: boolean };
}

/** What is kept of a run: enough to show any of its moments again, and to run it again up to one. */
export class Recording {
  /** Changes with each piece of the tape that comes, and when others take the place of thin ones. */
  readonly count = shallowRef(0);
  /**
   * The pieces, packed as they came: nothing is unpacked before somebody looks back. It is another list when others have
   * taken the place of thin ones: whoever has read some of them begins anew.
   */
  pieces: readonly Uint8Array[] = [];
  /** Of each piece: the time since which moments are missing, because it is thin; `null`: none are. */
  thinSince: readonly (number | null)[] = [];
  /** How many pieces there were, and until when, when all that was done to the run was told. */
  told = { pieces: 0, untilUs: 0 };
  /** What the programs have printed, oldest first, as it came; the oldest half goes when it is too much. */
  output: readonly Output[] = [];
  /** Pieces of output that are gone. */
  outputGone = 0;
  private readonly asking: ShallowRef<Asked | null> = shallowRef(null);
  /** A moment that somebody has asked to see: the time line goes there. `null`: it is there. */
  readonly asked: Readonly<ShallowRef<Asked | null>> = this.asking;
  private readonly question: ShallowRef<WhyAsked | null> = shallowRef(null);
  /** What somebody wants to know the line of; `null`: nothing. */
  readonly why: Readonly<ShallowRef<WhyAsked | null>> = this.question;
  /** Everything done to the run up to when the tape was asked for last; `null`: it was never said. */
  readonly inputs: ShallowRef<readonly InputEvent[] | null> = shallowRef(null);
  private readonly leftRun: ShallowRef<Recording | null>;
  /** The run that this one has left: what came there after the moment from which this one went on. `null`: none. */
  readonly ghost: Readonly<ShallowRef<Recording | null>>;

  /**
   * @param setup of the run; `null`: there is none
   * @param left the run that this one has left
   * @param brought it was recorded before, maybe by somebody else, and is looked at from its beginning on: its tape
   */
  constructor(
    readonly setup: RunSetup | null,
    left: Recording | null = null,
    private brought: BroughtTape | null = null,
  ) {
    this.ghost = this.leftRun = shallowRef(left);
    this.isBrought = brought !== null;
    this.as = brought;
    for (const piece of brought?.pieces ?? []) this.add(piece, null);
  }
  readonly isBrought: boolean;
  /** As it was brought; `null`: it was not. */
  readonly as: BroughtTape | null;

  /** The run can be run again. */
  get canGoOn(): boolean {
    return this.setup !== null && this.inputs.value !== null;
  }

  /** Asks for a moment; `null`: it is there, or nobody wants it any more. */
  ask(moment: Asked | null): void {
    this.asking.value = moment;
  }

  /** Asks for the lines behind something; `null`: nobody asks any more. */
  askWhy(question: WhyAsked | null): void {
    this.question.value = question;
  }

  /** Takes the run that was left out of sight. */
  hideGhost(): void {
    this.leftRun.value = null;
  }

  /** What the run's worker says of its tape. */
  hear(message: FromWorker): void {
    if (message.type === 'tape' && !this.brought) this.add(message.piece, message.thinSinceUs);
    if (message.type !== 'inputs') return;
    // Until here its moments were there before.
    if (this.brought && message.nowUs >= this.brought.untilUs) this.brought = null;
    this.told = { pieces: this.pieces.length, untilUs: message.nowUs };
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

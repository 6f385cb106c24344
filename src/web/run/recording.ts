import { computed, shallowRef, type ShallowRef } from 'vue';

import type { InputEvent } from '#simulation/input';
import type { RunSetup } from '#simulation/run-setup';
import type { FromWorker } from './worker/protocol';

/** What is kept of a run: enough to show any of its moments again, and to run it again up to one. */
export class Recording {
  /** Number of pieces of the tape; changes with each that comes. */
  readonly count = shallowRef(0);
  /** The pieces, packed as they came: nothing is unpacked before somebody looks back. */
  readonly pieces: Uint8Array[] = [];
  /** Everything done to the run up to when the tape was asked for last; `null`: it was never said. */
  readonly inputs: ShallowRef<readonly InputEvent[] | null> = shallowRef(null);
  /** The run can be run again. */
  readonly canGoOn = computed(() => this.setup !== null && this.inputs.value !== null);

  /** @param setup of the run; `null`: there is none */
  constructor(readonly setup: RunSetup | null) {}

  hear(message: Extract<FromWorker, { type: 'tape' | 'inputs' }>): void {
    if (message.type === 'inputs') this.inputs.value = message.inputs;
    else this.count.value = this.pieces.push(message.piece);
  }
}

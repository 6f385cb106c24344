import { shallowRef, type Ref, type ShallowRef } from 'vue';

import { lateModel } from '../../../kit/state/late-models';

/** Text that a real board has sent; of the form of a run's, so that both can be drawn alike. */
export interface BoardText {
  readonly device: 0;
  readonly text: string;
  /** The time since its program was started. */
  readonly timeUs: number;
}

/** A real board that is connected while the simulation is used, and what its program says. */
export interface RealBoard {
  readonly name: Ref<string>;
  /** `paused`: another tab is looked at; `gone`: the cable is out. */
  readonly state: Ref<'connected' | 'paused' | 'gone'>;
  /** Number of the program's start; with the next one the output begins anew. */
  readonly start: Ref<number>;
  /** Changes whenever something has come. */
  readonly count: Ref<number>;
  /** Everything since the start, as far as it is kept. */
  readonly output: readonly BoardText[];
  /** Number of earlier texts of this start that are not kept. */
  readonly outputGone: number;
  /** Sends text to its program. */
  send(text: string): void;
  /** Lets go of it; the line is free afterwards. */
  disconnect(): Promise<void>;
}

/** The board at the cable; `null`: there is none. It is made by the dialog that connects it. */
export const realBoard = lateModel((): ShallowRef<RealBoard | null> => shallowRef<RealBoard | null>(null));

import type { SharedWords } from '../threads/threads';

/** The initial data of a thread that makes runs. */
export interface RunnerData extends SharedWords {
  readonly firmware: WebAssembly.Module;
}

import type { Ref } from 'vue';

/** How what was made of a run becomes a file. */
export interface RunSaving {
  /** Something is being made: nothing else is taken. */
  readonly isBusy: Readonly<Ref<boolean>>;
  /**
   * Makes a file and saves it under the name of the course; says whether that worked.
   *
   * @param signal gives it up: then it is no failure
   */
  readonly saveRun: (ending: string, make: (name: string) => Promise<Blob>, signal?: AbortSignal) => Promise<void>;
}

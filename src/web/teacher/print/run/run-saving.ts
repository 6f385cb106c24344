import type { Ref } from 'vue';

/** Saves files that are made of a run. */
export interface RunSaving {
  /** True while a file is being made: no other is taken. */
  readonly isBusy: Readonly<Ref<boolean>>;
  /**
   * Makes a file and saves it under the name of the course; says whether that worked.
   *
   * @param signal gives it up: then it is no failure
   */
  readonly saveRun: (ending: string, make: (name: string) => Promise<Blob>, signal?: AbortSignal) => Promise<void>;
}

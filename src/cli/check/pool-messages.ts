import type { Project } from '#project/project';

/** The initial data of a thread that checks. */
export interface CheckerData {
  /** The project that contains the task. */
  readonly task: Project;
  readonly firmware: WebAssembly.Module;
  /** Its start program in other languages. */
  readonly starts: readonly string[];
  /** Shared words, see `BEAT` and `WORLD`. */
  readonly shared: Int32Array;
}

/** Index of the shared word that the thread counts up while time passes. */
export const BEAT = 0;

/** Index of the shared word that holds the place of the world that is being run. */
export const WORLD = 1;

import type { Project } from '#project/project';
import type { SharedWords } from '../threads/threads';

/** The initial data of a thread that checks. */
export interface CheckerData extends SharedWords {
  /** The project that contains the task. */
  readonly task: Project;
  readonly firmware: WebAssembly.Module;
  /** Its start program in other languages. */
  readonly starts: readonly string[];
}

import type { Board } from '#board/board';
import type { Clock } from '#core/clock';
import type { Observer } from './observed';

/** Everything that a VM needs to run a program. */
export interface VmSetup {
  /** The compiled firmware (.cache/vm/vm.wasm). */
  readonly firmware: WebAssembly.Module;
  readonly board: Board;
  readonly clock: Clock;
  /** The pupil's files by name; `main.py` is the program. */
  readonly files: Readonly<Record<string, string>>;
  /** The robot's libraries by name; a pupil's file of the same name wins. They do not show in `os.listdir()`. */
  readonly libraries: Readonly<Record<string, string>>;
  readonly seed: number;
  /**
   * When the REPL greets after the program's end: at once, as on the device, or (the default) with the first byte
   * typed, so that a run without input prints only the program's output.
   */
  readonly repl?: 'at-once' | 'when-typed';
  /** Receives what the program prints. */
  write(text: string): void;
  /** Notified of all that the program does to the board; left out: nothing is reported, at no cost. */
  readonly observer?: Observer | undefined;
}

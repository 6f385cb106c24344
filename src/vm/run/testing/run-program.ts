import { readFileSync } from 'node:fs';
import { Board } from '#board/board';
import { microbitV2 } from '#board/boards/microbit-v2';
import { Clock } from '#core/clock';
import { createVm, type Vm, type VmEnd } from '../vm';

/** The compiled firmware, for tests in Node. */
export const firmware = new WebAssembly.Module(readFileSync('.cache/vm/vm.wasm'));

/** A program on a bare micro:bit. */
export interface Device {
  readonly vm: Vm;
  readonly clock: Clock;
  readonly board: Board;
  /** The output so far. */
  readonly console: () => string;
}

/** The result of a program. */
export interface Outcome {
  readonly console: string;
  /** `null` if it was still running at the end of the given time. */
  readonly ended: VmEnd | null;
  readonly nowUs: number;
  readonly heapFree: number;
}

export interface ProgramOptions {
  readonly files?: Readonly<Record<string, string>>;
  readonly libraries?: Readonly<Record<string, string>>;
  readonly seed?: number;
  readonly repl?: 'at-once' | 'when-typed';
  /** False for a board without main.py. */
  readonly main?: boolean;
  /** Suspends the program whenever this many simulated µs have passed; by default never. */
  readonly sliceUs?: number;
  /** Gives up after this much simulated time; by default ten minutes. */
  readonly forUs?: number;
}

/** Puts a program on a micro:bit V2 without starting it. */
export function deviceWith(program: string, options: ProgramOptions = {}): Device {
  const clock = new Clock();
  const board = new Board(microbitV2, clock);
  let console = '';
  const vm = createVm({
    firmware,
    board,
    clock,
    files: options.main === false ? { ...options.files } : { ...options.files, 'main.py': program },
    libraries: options.libraries ?? {},
    seed: options.seed ?? 1,
    repl: options.repl ?? 'when-typed',
    write: (text) => {
      console += text;
    },
  });
  return { vm, clock, board, console: () => console };
}

/** Runs a program to its end. */
export function runProgram(program: string, options: ProgramOptions = {}): Outcome {
  const { vm, clock, console } = deviceWith(program, options);
  const forUs = options.forUs ?? 600_000_000;
  while (!vm.ended && clock.nowUs < forUs) vm.resume(Math.min(forUs, clock.nowUs + (options.sliceUs ?? Infinity)));
  return { console: console(), ended: vm.ended, nowUs: clock.nowUs, heapFree: vm.heapFree() };
}

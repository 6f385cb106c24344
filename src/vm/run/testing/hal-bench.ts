import { createBench, type Bench } from '#board/testing/bench';
import { createRng } from '#core/rng';
import { ConsolePort } from '../console-port';
import { Files } from '../files';
import { createHal } from '../hal/hal';
import type { Machine, Value } from '../syscall';

/** A board on the table whose syscalls a test calls by name, instead of a Python program. */
export interface HalBench {
  readonly bench: Bench;
  readonly port: ConsolePort;
  readonly files: Files;
  /** Memory for what would be Python's buffers. */
  readonly memory: Uint8Array;
  /** Callbacks queued so far. */
  readonly queued: number[];
  /** Everything sent over the serial line. */
  readonly sent: () => string;
  /** Names of all syscalls. */
  readonly names: readonly string[];
  /** Calls a syscall to its end; a wait that never ends is an error. */
  readonly call: (name: string, ...args: Value[]) => Value;
  /** The same, with the time that it took in µs. */
  readonly timed: (name: string, ...args: Value[]) => { value: Value; us: number };
  /** Calls a waiting syscall, and cuts the wait short after `us`, as a queued callback does. */
  readonly interrupted: (us: number, name: string, ...args: Value[]) => Value;
  /** Puts bytes at an address and gives the address. */
  readonly put: (bytes: readonly number[], address?: number) => number;
}

/** Puts a board with these files on the table. */
export function createHalBench(initial: Readonly<Record<string, string>> = {}): HalBench {
  const bench = createBench();
  const { clock } = bench;
  const memory = new Uint8Array(64 * 1024);
  const queued: number[] = [];
  const output: number[] = [];
  const machine: Machine = {
    clock,
    startUs: 0,
    onEnd: () => undefined,
    memory: (address, length) => memory.subarray(address, address + length),
    spend: (us) => clock.advanceTo(clock.nowUs + us),
    schedule: (callback) => queued.push(callback) > 0,
  };
  const port = new ConsolePort((bytes) => output.push(...bytes));
  const files = new Files(initial);
  const table = createHal(machine, bench.board, files, port, createRng(1));
  const run = (limitUs: number, name: string, args: readonly Value[]): Value => {
    const answer = table[name]?.(...args);
    if (answer === undefined) throw new Error(`There is no syscall ${name}.`);
    if (typeof answer !== 'object' || answer === null) return answer;
    const endUs = clock.nowUs + limitUs;
    while (clock.nowUs < answer.untilUs && !answer.ready?.() && clock.nowUs < endUs) {
      const next = Math.min(answer.untilUs, clock.nextAlarmUs, endUs);
      if (next === Infinity) throw new Error(`${name} waits for ever.`);
      clock.advanceTo(Math.max(next, clock.nowUs));
    }
    return answer.result();
  };
  return {
    bench,
    port,
    files,
    memory,
    queued,
    names: Object.keys(table),
    sent: () => new TextDecoder().decode(Uint8Array.from(output)),
    call: (name, ...args) => run(Infinity, name, args),
    timed: (name, ...args) => {
      const start = clock.nowUs;
      return { value: run(Infinity, name, args), us: clock.nowUs - start };
    },
    interrupted: (us, name, ...args) => run(us, name, args),
    put: (bytes, address = 0) => {
      memory.set(bytes, address);
      return address;
    },
  };
}

import { textOf } from '../arguments';
import type { ConsolePort } from '../console-port';
import type { Repl, Request } from '../repl';
import type { SyscallTable, Wait } from '../syscall';

const CTRL_C = 3;
/** The number that `repl()` gives Python for a request. */
const Code = { statement: 1, program: 2, names: 3, reboot: 4, pasted: 2 } as const;

/** The parts of the engine that the REPL's functions use. */
export interface ReplMachine {
  /** Forgets a pending KeyboardInterrupt. */
  forgetInterrupt(): void;
  /** Sets whether code that is compiled from now on prints the values of its expressions. */
  echo(on: boolean): void;
}

/**
 * The REPL's side of the runner. Python only compiles and runs; `Repl` handles what is typed and shown.
 *
 * - repl() waits → 1 a statement, 2 a program, 3 names are requested, 4 reboot; None if a callback came in between
 * - repl_text() → the source, or the path of the object whose names are requested · repl_names(text) ← them, by spaces
 * - repl_run(on): whether Ctrl-C interrupts from now on · repl_fail(): a traceback follows
 * - repl_raw() → whether tools talk to the board, so that main.py is not run
 */
export function createReplCalls(repl: Repl, port: ConsolePort, machine: ReplMachine): SyscallTable {
  let request: Request | null = null;
  const interrupts = (on: boolean): void => {
    port.interruptByte = on ? CTRL_C : null;
    machine.echo(false);
    if (!on) machine.forgetInterrupt();
  };
  return {
    repl: (): Wait => {
      interrupts(false);
      repl.listen();
      return {
        untilUs: Infinity,
        ready: () => (request ??= repl.next()) !== null,
        result: () => (request === null ? null : Code[request.type]),
      };
    },
    repl_text: () => {
      const given = request;
      request = null;
      machine.echo(given?.type === 'pasted');
      if (given === null || given.type === 'reboot') return '';
      return given.type === 'names' ? given.path : given.source;
    },
    repl_names: (names) => {
      repl.complete(
        textOf(names)
          .split(' ')
          .filter((name) => name !== ''),
      );
      return null;
    },
    repl_run: (on) => {
      interrupts(on === true);
      return null;
    },
    repl_fail: () => {
      repl.fail();
      return null;
    },
    repl_raw: () => repl.isRaw,
  };
}

import type { SyscallTable, Value } from './syscall';

/** Notified of all that a program does to its board while it does it, so that the program's place can be read. */
export interface Observer {
  /** A call of the device begins: what happens until `after` happens by it. */
  before(): void;
  /** @param call its name in the module `_hal` */
  after(call: string, given: readonly (Value | undefined)[]): void;
  /** These bytes are printed; the time that it takes is still to come. */
  print(bytes: Uint8Array): void;
}

/** Wraps syscalls so that an observer is notified of each. Their answers and costs stay the same. */
export function observed(table: SyscallTable, observer: Observer): SyscallTable {
  const listenTo = ([name, call]: [string, SyscallTable[string]]): [string, SyscallTable[string]] => [
    name,
    (...given) => {
      observer.before();
      const answer = call(...given);
      observer.after(name, given);
      return answer;
    },
  ];
  return Object.fromEntries(Object.entries(table).map(listenTo));
}

import type { Board } from '#board/board';
import { wholeOf } from './arguments';
import type { ConsolePort } from './console-port';
import type { Machine, SyscallTable, Wait } from './syscall';

const BITS_PER_BYTE = 10; // start bit, eight data bits, stop bit
const START_BAUD = 115_200; // micropython-microbit-v2 README: the REPL's speed
const Key = { CTRL_D: 4, BACKSPACE: 8, NEWLINE: 10, RETURN: 13, FIRST_PRINTABLE: 32, DELETE: 127 } as const;
const END_OF_INPUT = 4;
const RUB_OUT = Uint8Array.of(8, 32, 8);
const LINE_END = Uint8Array.of(10); // as print ends a line

/**
 * The serial line.
 *
 * - serial_input() waits for a line and echoes it → text, None when a callback came in between (call again; what was
 *   typed is kept), 4 for Ctrl-D on an empty line
 * - serial_waiting(), serial_line() → how many bytes wait, in all or up to the next newline
 * - serial_read(address, bytes) · serial_write(address, bytes) · serial_init(baud)
 */
export function createConsoleCalls(machine: Machine, board: Board, port: ConsolePort): SyscallTable {
  const { callUs } = board.type.costsUs;
  let byteUs = (BITS_PER_BYTE * 1_000_000) / START_BAUD;
  const line = createLineEditor(port);
  return {
    serial_input: (): Wait => ({ untilUs: Infinity, ready: line.isDone, result: line.take }),
    serial_waiting: () => {
      machine.spend(callUs);
      return port.waiting;
    },
    serial_line: () => {
      machine.spend(callUs);
      return port.lineLength;
    },
    serial_read: (address, count) => {
      const target = machine.memory(wholeOf(address) ?? 0, wholeOf(count) ?? 0);
      for (let i = 0; i < target.length; i++) target[i] = port.take() ?? 0;
      return null;
    },
    serial_write: (address, count) => {
      const bytes = machine.memory(wholeOf(address) ?? 0, wholeOf(count) ?? 0).slice();
      machine.spend(Math.round(callUs + byteUs * bytes.length));
      port.write(bytes);
      return null;
    },
    serial_init: (baud) => {
      machine.spend(callUs);
      byteUs = (BITS_PER_BYTE * 1_000_000) / Math.max(wholeOf(baud) ?? START_BAUD, 1);
      return null;
    },
  };
}

/** Reads a line key by key with echo, as the device's readline does: Return or newline ends it, backspace rubs out. */
function createLineEditor(port: ConsolePort): { isDone: () => boolean; take: () => string | number | null } {
  let typed: number[] = [];
  let done: string | number | null = null;
  let lastWasReturn = false;
  const key = (byte: number): void => {
    // Return and newline one after the other are one end of line, not two.
    if (byte === Key.NEWLINE && lastWasReturn) {
      lastWasReturn = false;
      return;
    }
    lastWasReturn = byte === Key.RETURN;
    if (byte === Key.RETURN || byte === Key.NEWLINE) {
      port.write(LINE_END);
      done = new TextDecoder().decode(Uint8Array.from(typed));
      typed = [];
    } else if (byte === Key.CTRL_D && typed.length === 0) {
      done = END_OF_INPUT;
    } else if (byte === Key.BACKSPACE || byte === Key.DELETE) {
      if (typed.pop() !== undefined) port.write(RUB_OUT);
    } else if (byte >= Key.FIRST_PRINTABLE) {
      typed.push(byte);
      port.write(Uint8Array.of(byte));
    }
  };
  return {
    isDone: () => {
      while (done === null) {
        const byte = port.take();
        if (byte === undefined) break;
        key(byte);
      }
      return done !== null;
    },
    take: () => {
      const line = done;
      done = null;
      return line;
    },
  };
}

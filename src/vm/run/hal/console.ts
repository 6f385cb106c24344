import type { ConsolePort } from '../console-port';
import { LineEditor } from '../line-editor';
import type { SyscallTable, Wait } from '../syscall';

/** The answer of `serial_input` for Ctrl-C (where it does not interrupt) and for Ctrl-D on an empty line. */
const CTRL_C = 3;
const CTRL_D = 4;

/**
 * The serial line as `input()` sees it.
 *
 * - serial_input(fresh) waits for a line and echoes it → text, None if a callback came in between (call again with
 *   False; typed characters are kept), 3 for Ctrl-C, 4 for Ctrl-D on an empty line
 */
export function createConsoleCalls(port: ConsolePort): SyscallTable {
  const encoder = new TextEncoder();
  const editor = new LineEditor((text) => port.write(encoder.encode(text)));
  let done: string | number | null = null;
  const isDone = (): boolean => {
    while (done === null) {
      const byte = port.take();
      if (byte === undefined) return false;
      const signal = editor.key(byte);
      if (signal === 'line') done = editor.text;
      if (signal === 'ctrl-c') done = CTRL_C;
      if (signal === 'ctrl-d') done = CTRL_D;
    }
    return true;
  };
  return {
    serial_input: (fresh): Wait => {
      if (fresh !== false) {
        done = null;
        editor.begin('');
      }
      port.awaitsLine = true;
      return {
        untilUs: Infinity,
        ready: isDone,
        result: () => {
          port.awaitsLine = false;
          return done;
        },
      };
    },
  };
}

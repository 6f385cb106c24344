import type { Board } from '#board/board';
import { wholeOf } from '../arguments';
import type { ConsolePort } from '../console-port';
import { pinsByNumber } from './pins';
import type { Machine, SyscallTable, Value, Wait } from '../syscall';

/** micropython-microbit-v2 microbit_uart.c: how long a read waits for the next byte is 13 bits, in whole ms and one more. */
const GAP_BITS_MS = 13_000;

/**
 * The serial line as `uart` sees it: the console, or chips on pins.
 *
 * - uart_init(baud, tx, rx): pins by number, −1 for the USB socket
 * - uart_waiting(), uart_line() → number of waiting bytes, in all or up to the next newline
 * - uart_more() waits for the byte after the last one → True if one has come, False if the gap was too long, None if a
 *   callback came in between (call again)
 * - uart_read(address, bytes) · uart_write(address, bytes)
 */
export function createUartCalls(machine: Machine, board: Board, port: ConsolePort): SyscallTable {
  const { uart } = board;
  const { clock } = machine;
  const { callUs } = board.type.costsUs;
  const pins = pinsByNumber(board);
  const at = (n: Value | undefined) => pins[wholeOf(n) ?? -1] ?? null;
  const source = () => (uart.pins.rx ? uart : port);
  let gapUs = 0; // until the first init a read does not wait at all
  let gapEndUs: number | null = null;
  return {
    uart_init: (baud, tx, rx) => {
      machine.spend(callUs);
      const wish = wholeOf(baud) ?? 0;
      uart.init(wish, { tx: at(tx), rx: at(rx) });
      gapUs = wish > 0 ? (Math.floor(GAP_BITS_MS / wish) + 1) * 1000 : 1000;
      return null;
    },
    uart_waiting: () => {
      machine.spend(callUs);
      return source().waiting;
    },
    uart_line: () => {
      machine.spend(callUs);
      return source().lineLength;
    },
    uart_more: (): Wait => {
      const endUs = (gapEndUs ??= clock.nowUs + gapUs);
      const isThere = (): boolean => source().waiting > 0;
      return {
        untilUs: isThere() ? clock.nowUs : endUs,
        ready: isThere,
        result: () => {
          if (!isThere() && clock.nowUs < endUs) return null;
          gapEndUs = null;
          return isThere();
        },
      };
    },
    uart_read: (address, count) => {
      const target = machine.memory(wholeOf(address) ?? 0, wholeOf(count) ?? 0);
      for (let i = 0; i < target.length; i++) target[i] = source().take() ?? 0;
      return null;
    },
    uart_write: (address, count): Wait => {
      const bytes = machine.memory(wholeOf(address) ?? 0, wholeOf(count) ?? 0).slice();
      return {
        untilUs: clock.nowUs + Math.round(callUs + uart.byteUs * bytes.length),
        solid: true,
        result: () => {
          if (uart.pins.tx) uart.send(bytes);
          else port.write(bytes);
          return null;
        },
      };
    },
  };
}

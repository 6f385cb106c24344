import type { Board } from '#board/board';
import type { LogEntry } from '#board/data-log';
import { textOf, wholeOf } from '../arguments';
import type { ConsolePort } from '../console-port';
import type { Machine, SyscallTable } from '../syscall';

/**
 * The data log.
 *
 * - log_timestamp(unit) → False for an unknown one · log_mirror(on) · log_delete()
 * - log_begin(), log_put(heading, value) …, log_end() → False when the log is full
 */
export function createLogCalls(machine: Machine, board: Board, port: ConsolePort): SyscallTable {
  const { dataLog } = board;
  const { callUs, printByteUs, logLineUs, logByteUs } = board.type.costsUs;
  const encoder = new TextEncoder();
  const mirror = (line: string): void => {
    const bytes = encoder.encode(`${line}\n`);
    machine.spend(bytes.length * printByteUs);
    port.write(bytes);
  };
  let row: LogEntry[] = [];
  return {
    log_timestamp: (unit) => {
      machine.spend(callUs);
      return dataLog.setTimestamp(wholeOf(unit) ?? -1);
    },
    log_mirror: (on) => {
      machine.spend(callUs);
      dataLog.mirrorTo(on === true ? mirror : null);
      return null;
    },
    log_delete: () => {
      machine.spend(callUs);
      dataLog.delete();
      return null;
    },
    log_begin: () => {
      row = [];
      return null;
    },
    log_put: (heading, value) => {
      row.push([textOf(heading), textOf(value)]);
      return null;
    },
    log_end: () => {
      const nowMs = Math.floor((machine.clock.nowUs - machine.startUs) / 1000);
      machine.spend(callUs);
      const { byteCount } = dataLog;
      const fits = dataLog.add(row, nowMs);
      const bytes = dataLog.byteCount - byteCount;
      if (bytes > 0) machine.spend(logLineUs + logByteUs * bytes);
      return fits;
    },
  };
}

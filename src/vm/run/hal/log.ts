import type { Board } from '#board/board';
import type { LogEntry } from '#board/data-log';
import { textOf, wholeOf } from '../arguments';
import type { ConsolePort } from '../console-port';
import type { Machine, SyscallTable } from '../syscall';

/**
 * The data log.
 *
 * - log_timestamp(unit) · log_mirror(on) · log_delete()
 * - log_row(text, isWhole) → False when the log is full; headings and values, each with a zero character after it; a row
 *   that an error has cut off is written when the next one begins (MicroBitLog.cpp, beginRow)
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
  let row: LogEntry[] | null = null;
  const end = (): boolean => {
    const nowMs = Math.floor((machine.clock.nowUs - machine.startUs) / 1000);
    machine.spend(callUs);
    const { byteCount } = dataLog;
    const fits = dataLog.add(row ?? [], nowMs);
    row = null;
    const bytes = dataLog.byteCount - byteCount;
    if (bytes > 0) machine.spend(logLineUs + logByteUs * bytes);
    return fits;
  };
  return {
    log_timestamp: (unit) => {
      machine.spend(callUs);
      dataLog.setTimestamp(wholeOf(unit) ?? 0);
      return null;
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
    log_row: (text, isWhole) => {
      if (row) end();
      row = entriesOf(textOf(text));
      return isWhole !== true || end();
    },
  };
}

function entriesOf(text: string): LogEntry[] {
  const parts = text.split('\0');
  const entries: LogEntry[] = [];
  for (let place = 0; place + 1 < parts.length; place += 2) entries.push([parts[place] ?? '', parts[place + 1] ?? '']);
  return entries;
}

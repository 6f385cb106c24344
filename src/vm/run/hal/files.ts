import type { Board } from '#board/board';
import { Errno, textOf, wholeOf } from '../arguments';
import { readableBytes, reportedSize, type Files } from '../files';
import type { Machine, SyscallTable } from '../syscall';

/** The units that `file_span` counts in. */
const Unit = { BYTES: 0, CHARACTERS: 1, LINE: 2 } as const;
const NEWLINE = 10;

/**
 * Files for the modules os and the built-in open. An open file is a Python object alone, as on the device: it keeps the
 * file's number and its own place, so that any number of them may be left open.
 *
 * - file_name(index) → name or None · file_size(name) → bytes or −ENOENT · file_remove(name) → 0 or −ENOENT
 * - file_open(name, writable) → the file's number ≥ 0, −ENOENT, −ENOSPC; a file to write is emptied
 * - file_span(number, place, unit, count) → how many bytes from `place` the next `count` bytes (0), characters (1), or
 *   the next line of at most `count` bytes (2) take, `count` < 0 for no limit; −EBADF
 * - file_read(number, place, address, bytes) → bytes, −EBADF · file_write(number, address, bytes) appends → bytes,
 *   −EBADF, −ENOSPC · file_close(number), of a file that was written
 */
export function createFileCalls(machine: Machine, files: Files, board: Board): SyscallTable {
  const { callUs } = board.type.costsUs;
  const use = <T>(value: T): T => {
    machine.spend(callUs);
    return value;
  };
  const restOf = (number: unknown, place: unknown): Uint8Array | undefined => {
    const file = files.byNumber(Number(number));
    return file && readableBytes(file).subarray(Math.max(0, Number(place) || 0));
  };
  return {
    file_name: (index) => files.names[wholeOf(index) ?? 0] ?? null,
    file_size: (name) => {
      const file = files.find(textOf(name));
      return file ? reportedSize(file) : -Errno.ENOENT;
    },
    file_remove: (name) => use(files.remove(textOf(name)) ? 0 : -Errno.ENOENT),
    file_open: (name, writable) => {
      // A new program makes the log worthless: microbitfs.c, microbit_file_open.
      if (writable && textOf(name) === 'main.py') board.dataLog.invalidate();
      const file = writable ? files.create(textOf(name)) : (files.find(textOf(name)) ?? -Errno.ENOENT);
      return use(typeof file === 'number' ? file : file.id);
    },
    file_close: (number) => {
      const file = files.byNumber(Number(number));
      if (file) file.isClosed = true;
      return null;
    },
    file_span: (number, place, unit, count) => {
      const rest = restOf(number, place);
      return rest ? use(spanOf(rest, wholeOf(unit) ?? 0, wholeOf(count) ?? -1)) : -Errno.EBADF;
    },
    file_read: (number, place, address, bytes) => {
      const part = restOf(number, place)?.subarray(0, Math.max(0, wholeOf(bytes) ?? 0));
      if (!part) return -Errno.EBADF;
      const target = machine.memory(wholeOf(address) ?? 0, part.length);
      target.set(part.subarray(0, target.length));
      return part.length;
    },
    file_write: (number, address, bytes) => {
      const file = files.byNumber(Number(number));
      if (!file) return -Errno.EBADF;
      const data = machine.memory(wholeOf(address) ?? 0, wholeOf(bytes) ?? 0).slice();
      return use(files.append(file, data) || data.length);
    },
  };
}

function spanOf(rest: Uint8Array, unit: number, count: number): number {
  const limit = count < 0 ? rest.length : Math.min(count, rest.length);
  if (unit === Unit.LINE) {
    const end = rest.indexOf(NEWLINE);
    return Math.min(end < 0 ? rest.length : end + 1, limit);
  }
  if (unit === Unit.BYTES || count < 0) return limit;
  let bytes = 0;
  for (let characters = 0; characters < count && bytes < rest.length; characters++) {
    bytes++;
    // UTF-8: the further bytes of a character are 10xxxxxx.
    while (bytes < rest.length && ((rest[bytes] ?? 0) & 0xc0) === 0x80) bytes++;
  }
  return bytes;
}

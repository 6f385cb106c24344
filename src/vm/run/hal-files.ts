import { Errno, textOf, wholeOf } from './arguments';
import type { Files, StoredFile } from './files';
import type { Machine, SyscallTable } from './syscall';

interface OpenFile {
  readonly file: StoredFile;
  readonly writable: boolean;
  position: number;
}

/** What `file_span` counts. */
const Unit = { BYTES: 0, CHARACTERS: 1, LINE: 2 } as const;
const NEWLINE = 10;

/**
 * Files for the modules os and the built-in open:
 *
 * - file_name(index) → name or None · file_size(name) → bytes or −ENOENT · file_remove(name) → 0 or −ENOENT
 * - file_open(name, writable) → handle ≥ 0, −ENOENT, −ENOSPC · file_close(handle)
 * - file_span(handle, unit, count) → how many bytes the next `count` bytes (0), characters (1), or the next line of at
 *   most `count` bytes (2) take, `count` < 0 for no limit; −EBADF · file_read(handle, address, bytes)
 * - file_write(handle, address, bytes) → bytes, −EBADF, −ENOSPC
 */
export function createFileCalls(machine: Machine, files: Files, callUs: number): SyscallTable {
  const open = new Map<number, OpenFile>();
  const use = <T>(value: T): T => {
    machine.spend(callUs);
    return value;
  };
  const opened = (handle: unknown): OpenFile | undefined => open.get(Number(handle));
  return {
    file_name: (index) => files.names[wholeOf(index) ?? 0] ?? null,
    file_size: (name) => files.find(textOf(name))?.bytes.length ?? -Errno.ENOENT,
    file_remove: (name) => use(files.remove(textOf(name)) ? 0 : -Errno.ENOENT),
    file_open: (name, writable) => {
      const file = writable ? files.create(textOf(name)) : (files.find(textOf(name)) ?? -Errno.ENOENT);
      if (typeof file === 'number') return use(file);
      let handle = 0;
      while (open.has(handle)) handle++;
      open.set(handle, { file, writable: writable === true, position: 0 });
      return use(handle);
    },
    file_close: (handle) => {
      open.delete(Number(handle));
      return use(null);
    },
    file_span: (handle, unit, count) => {
      const one = opened(handle);
      if (!one || one.writable || !files.has(one.file)) return -Errno.EBADF;
      return use(spanOf(one.file.bytes.subarray(one.position), wholeOf(unit) ?? 0, wholeOf(count) ?? -1));
    },
    file_read: (handle, address, bytes) => {
      const one = opened(handle);
      if (!one) return -Errno.EBADF;
      const part = one.file.bytes.subarray(one.position, one.position + (wholeOf(bytes) ?? 0));
      machine.memory(wholeOf(address) ?? 0, part.length).set(part);
      one.position += part.length;
      return part.length;
    },
    file_write: (handle, address, bytes) => {
      const one = opened(handle);
      if (!one?.writable) return -Errno.EBADF;
      const data = machine.memory(wholeOf(address) ?? 0, wholeOf(bytes) ?? 0).slice();
      return use(files.append(one.file, data) || data.length);
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

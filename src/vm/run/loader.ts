import type { Memory } from './values';

/** Functions that the firmware imports, by name. */
export type HostFunctions = Readonly<Record<string, (...args: never[]) => unknown>>;

/** The host functions through which the firmware finds and reads the files it imports. */
export interface Loader {
  readonly environment: HostFunctions;
  readonly wasi: HostFunctions;
  /** Forgets the files that are open. */
  closeAll(): void;
}

/** Gives the bytes of a file by its path (`main.py`, `/lib/microbit.mpy`), or `undefined` if there is no such file. */
export type FileLookup = (path: string) => Uint8Array | undefined;

const ENOENT = 44; // WASI error numbers
const EBADF = 8;
const EROFS = 69;
const REGULAR_FILE = 0o100000;
const DIRECTORY = 0o040000;
const WRITE_FLAGS = 3 | 0o100 | 0o1000; // O_WRONLY, O_RDWR, O_CREAT, O_TRUNC
const FIRST_FILE = 3; // 0, 1, 2 are the console
/** Offsets of mode and size in the `struct stat` of the firmware's C library. */
const STAT_BYTES = 96;
const STAT_MODE = 4;
const STAT_SIZE = 24;

/** A read-only file system with a flat root and the library's folder, for `import` and nothing else. */
export function createLoader(lookup: FileLookup, memory: () => Memory): Loader {
  const open = new Map<number, { readonly bytes: Uint8Array; position: number }>();
  const pathAt = (address: number): string => memory().textUntilZero(address).replace(/^\.\//, '');
  const writeStat = (out: number, mode: number, bytes: number): number => {
    memory().bytes.fill(0, out, out + STAT_BYTES);
    memory().setWord(out + STAT_MODE, mode);
    memory().setWord(out + STAT_SIZE, bytes);
    return 0;
  };
  const stat = (pathAddress: number, out: number): number => {
    const path = pathAt(pathAddress);
    if (path === '/' || path === '/lib' || path === '.') return writeStat(out, DIRECTORY, 0);
    const bytes = lookup(path);
    return bytes ? writeStat(out, REGULAR_FILE, bytes.length) : -ENOENT;
  };
  return {
    environment: {
      __syscall_stat64: stat,
      __syscall_lstat64: stat,
      __syscall_newfstatat: (_folder: number, path: number, out: number) => stat(path, out),
      __syscall_fstat64: (file: number, out: number) => {
        const opened = open.get(file);
        return opened ? writeStat(out, REGULAR_FILE, opened.bytes.length) : -EBADF;
      },
      __syscall_openat: (_folder: number, path: number, flags: number) => {
        if (flags & WRITE_FLAGS) return -EROFS;
        const bytes = lookup(pathAt(path));
        if (!bytes) return -ENOENT;
        let file = FIRST_FILE;
        while (open.has(file)) file++;
        open.set(file, { bytes, position: 0 });
        return file;
      },
      __syscall_getcwd: (out: number, size: number) => {
        if (size < 2) return -1;
        memory().bytes.set([47, 0], out);
        return 2;
      },
    },
    wasi: { ...reading(memory, open), fd_close: (file: number) => (open.delete(file) ? 0 : EBADF) },
    closeAll: () => open.clear(),
  };
}

function reading(
  memory: () => Memory,
  open: ReadonlyMap<number, { readonly bytes: Uint8Array; position: number }>,
): HostFunctions {
  return {
    fd_read: (file: number, vectors: number, count: number, out: number) => {
      const opened = open.get(file);
      if (!opened) return EBADF;
      let total = 0;
      for (let i = 0; i < count; i++) {
        const address = memory().word(vectors + 8 * i);
        const wanted = memory().word(vectors + 8 * i + 4);
        const part = opened.bytes.subarray(opened.position, opened.position + wanted);
        memory().bytes.set(part, address);
        opened.position += part.length;
        total += part.length;
      }
      memory().setWord(out, total);
      return 0;
    },
    fd_seek: () => EBADF,
  };
}

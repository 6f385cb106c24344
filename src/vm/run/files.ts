import { Errno } from './arguments';

const CHUNK_BYTES = 126; // micropython microbitfs.c: chunks of 128 bytes, two of them for the links
const CHUNK_COUNT = 192; // chosen: 24 kB of flash in chunks of 128 bytes
const HEADER_BYTES = 2; // microbitfs.c file_header: end offset and length of the name, before the name
const ERASED = 255; // a byte of flash that nobody has written
const MAX_NAME_CHARACTERS = 120; // microbitfs.c: MAX_FILENAME_LENGTH

/** One stored file. The object stays the same until the file is removed or overwritten. */
export interface StoredFile {
  /** Its number: no other file of this board ever gets it. */
  readonly id: number;
  readonly name: string;
  bytes: Uint8Array;
  /** False while it is being written: only `close` notes where its last chunk ends. */
  isClosed: boolean;
}

/**
 * The board's file system: flat, in the order in which the files were written, 24 kB in chunks of 126 bytes. Names
 * count too. Source: micropython ports/nrf/modules/os/microbitfs.c.
 */
export class Files {
  private readonly stored = new Map<string, StoredFile>();
  private readonly byId = new Map<number, StoredFile>();
  private nextId = 0;

  /** @param initial the files on the board from the start, accepted even if they do not fit (see `fileHint`) */
  constructor(initial: Readonly<Record<string, string>> = {}) {
    const encoder = new TextEncoder();
    for (const [name, text] of Object.entries(initial)) this.store(name, encoder.encode(text));
  }

  /** All names, oldest first. */
  get names(): readonly string[] {
    return [...this.stored.keys()];
  }

  /** The file of this name, or `undefined`. */
  find(name: string): StoredFile | undefined {
    return this.stored.get(name);
  }

  /** The file with this number, or `undefined` if it was removed or overwritten. */
  byNumber(id: number): StoredFile | undefined {
    return this.byId.get(id);
  }

  /** Creates a file, or empties it. @returns the file, or a negative errno: name too long, no room */
  create(name: string): StoredFile | number {
    if (Array.from(name).length > MAX_NAME_CHARACTERS) return -Errno.ENOENT;
    this.remove(name);
    if (this.freeChunks < 1) return -Errno.ENOSPC;
    const file = this.store(name, new Uint8Array(0));
    file.isClosed = false;
    return file;
  }

  /** Appends bytes. If they do not fit, the whole file is lost, as on the device. @returns 0 or a negative errno */
  append(file: StoredFile, bytes: Uint8Array): number {
    if (!this.byId.has(file.id)) return -Errno.EBADF;
    const more = chunksOf(file.name, file.bytes.length + bytes.length) - chunksOf(file.name, file.bytes.length);
    if (more > this.freeChunks) {
      this.remove(file.name);
      return -Errno.ENOSPC;
    }
    const joined = new Uint8Array(file.bytes.length + bytes.length);
    joined.set(file.bytes);
    joined.set(bytes, file.bytes.length);
    file.bytes = joined;
    return 0;
  }

  /** Removes a file. @returns false if it does not exist */
  remove(name: string): boolean {
    const file = this.stored.get(name);
    if (!file) return false;
    this.byId.delete(file.id);
    return this.stored.delete(name);
  }

  private store(name: string, bytes: Uint8Array): StoredFile {
    const file: StoredFile = { id: this.nextId++, name, bytes, isClosed: true };
    this.stored.set(name, file);
    this.byId.set(file.id, file);
    return file;
  }

  private get freeChunks(): number {
    let used = 0;
    for (const file of this.stored.values()) used += chunksOf(file.name, file.bytes.length);
    return CHUNK_COUNT - used;
  }
}

/**
 * The bytes that a reader finds in a file: until it is closed, its last chunk reads as nothing (microbitfs.c,
 * file_read).
 */
export function readableBytes({ name, bytes, isClosed }: StoredFile): Uint8Array {
  if (isClosed) return bytes;
  return bytes.subarray(0, Math.max((chunksOf(name, bytes.length) - 1) * CHUNK_BYTES - headerBytes(name), 0));
}

/** The result of `os.size`: until a file is closed, its end is taken from erased flash (file_size). */
export function reportedSize({ name, bytes, isClosed }: StoredFile): number {
  if (isClosed) return bytes.length;
  return (chunksOf(name, bytes.length) - 1) * CHUNK_BYTES + ERASED - headerBytes(name);
}

/**
 * The message of a real board about files that a run starts with, in words for the user; `null` if they fit. It is only
 * a hint: the simulated board accepts them anyway, since drivers of others may be larger than the free space.
 */
export function fileHint(files: Readonly<Record<string, string>>): string | null {
  let chunks = 0;
  for (const [name, text] of Object.entries(files)) {
    const length = Array.from(name).length;
    if (length > MAX_NAME_CHARACTERS)
      return `The file name ${name} has ${length} characters; the board takes ${MAX_NAME_CHARACTERS}.`;
    chunks += chunksOf(name, new TextEncoder().encode(text).length);
  }
  if (chunks <= CHUNK_COUNT) return null;
  const kB = (count: number): string => ((count * CHUNK_BYTES) / 1000).toFixed(1);
  return `The files need ${kB(chunks)} kB on the board, which has ${kB(CHUNK_COUNT)} kB.`;
}

const headerBytes = (name: string): number => HEADER_BYTES + new TextEncoder().encode(name).length;

function chunksOf(name: string, bytes: number): number {
  return Math.floor((headerBytes(name) + bytes) / CHUNK_BYTES) + 1;
}

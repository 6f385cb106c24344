import { Errno } from './arguments';

const CHUNK_BYTES = 126; // micropython microbitfs.c: chunks of 128 bytes, two of them for the links
const CHUNK_COUNT = 192; // chosen: 24 kB of flash in chunks of 128 bytes
const HEADER_BYTES = 2; // microbitfs.c file_header: end offset and length of the name, before the name
const MAX_NAME_CHARACTERS = 120; // microbitfs.c: MAX_FILENAME_LENGTH

/** One stored file. The object stays the same until the file is removed or written anew. */
export interface StoredFile {
  readonly name: string;
  bytes: Uint8Array;
}

/**
 * The board's file system: flat, in the order in which the files were written, 24 kB in chunks of 126 bytes. Names
 * count too. Source: micropython ports/nrf/modules/os/microbitfs.c.
 */
export class Files {
  private readonly stored = new Map<string, StoredFile>();

  /** @param initial what is on the board from the start; it is taken as it is, even when it does not fit (see `fileProblem`) */
  constructor(initial: Readonly<Record<string, string>> = {}) {
    const encoder = new TextEncoder();
    for (const [name, text] of Object.entries(initial)) this.stored.set(name, { name, bytes: encoder.encode(text) });
  }

  /** All names, oldest first. */
  get names(): readonly string[] {
    return [...this.stored.keys()];
  }

  /** The file of this name, or `undefined`. */
  find(name: string): StoredFile | undefined {
    return this.stored.get(name);
  }

  /** True while this very file is still there: neither removed nor begun anew. */
  has(file: StoredFile): boolean {
    return this.stored.get(file.name) === file;
  }

  /** Begins a file anew, empty. @returns the file, or a negative errno: name too long, no room */
  create(name: string): StoredFile | number {
    if (Array.from(name).length > MAX_NAME_CHARACTERS) return -Errno.ENOENT;
    this.stored.delete(name);
    if (this.freeChunks < 1) return -Errno.ENOSPC;
    const file: StoredFile = { name, bytes: new Uint8Array(0) };
    this.stored.set(name, file);
    return file;
  }

  /** Adds bytes at the end. When they do not fit, the whole file is lost, as on the device. @returns 0 or a negative errno */
  append(file: StoredFile, bytes: Uint8Array): number {
    if (!this.has(file)) return -Errno.EBADF;
    const more = chunksOf(file.name, file.bytes.length + bytes.length) - chunksOf(file.name, file.bytes.length);
    if (more > this.freeChunks) {
      this.stored.delete(file.name);
      return -Errno.ENOSPC;
    }
    const joined = new Uint8Array(file.bytes.length + bytes.length);
    joined.set(file.bytes);
    joined.set(bytes, file.bytes.length);
    file.bytes = joined;
    return 0;
  }

  /** Removes a file. @returns false when there is none */
  remove(name: string): boolean {
    return this.stored.delete(name);
  }

  private get freeChunks(): number {
    let used = 0;
    for (const file of this.stored.values()) used += chunksOf(file.name, file.bytes.length);
    return CHUNK_COUNT - used;
  }
}

/** What is wrong with files for a board, in words for the user; `null` when they fit. */
export function fileProblem(files: Readonly<Record<string, string>>): string | null {
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

function chunksOf(name: string, bytes: number): number {
  return Math.floor((HEADER_BYTES + new TextEncoder().encode(name).length + bytes) / CHUNK_BYTES) + 1;
}

import type { Region } from './firmware';
import { APPENDED, CHUNK_BYTES, type Layout } from './layout';
import { bytesAt } from './memory';

/** A file as it lies in the flash. */
export interface StoredFile {
  readonly name: string;
  readonly bytes: Uint8Array;
}

/** A chunk has its marker, its data, and the number of the next one: `filesystem.c` of the board's MicroPython. */
const FILE_START = 0xfe;
const LAST = 0xff;
const DATA_BYTES = CHUNK_BYTES - 2;
const HEADER_BYTES = 2;

const APPENDED_BYTES = 0x2000;
const APPENDED_HEADER = 4;

/** Bytes that a file takes in the flash: whole chunks; the one behind its last byte begins already. */
export const storedBytes = (name: string, content: Uint8Array): number =>
  CHUNK_BYTES * Math.ceil((HEADER_BYTES + new TextEncoder().encode(name).length + content.length + 1) / DATA_BYTES);

/** The files in the flash by their place; `null`: their chunks do not fit together. */
export function storedFiles(regions: readonly Region[], layout: Layout): readonly StoredFile[] | null {
  const { filesStart, filesEnd, pageBytes, isOldChip } = layout;
  const isFirstEmpty = isOldChip && bytesAt(regions, filesStart, pageBytes).every((byte) => byte === 0xff);
  // uflash, and with it Mu, numbers the chunks of a V1 from the second page on.
  const others = (): readonly StoredFile[] | null =>
    isFirstEmpty ? filesFrom(regions, filesStart + pageBytes, filesEnd) : null;
  return filesFrom(regions, filesStart, filesEnd) ?? others();
}

function filesFrom(regions: readonly Region[], start: number, end: number): readonly StoredFile[] | null {
  const flash = bytesAt(regions, start, end - start);
  const count = flash.length / CHUNK_BYTES;
  const files: StoredFile[] = [];
  for (let number = 1; number <= count; number++) {
    if (flash[(number - 1) * CHUNK_BYTES] !== FILE_START) continue;
    const file = fileFrom(flash, number, count);
    if (file === null || files.some(({ name }) => name === file.name)) return null;
    files.push(file);
  }
  return files;
}

/** The file that begins in a chunk; the chunks are numbered from 1. */
function fileFrom(flash: Uint8Array, first: number, count: number): StoredFile | null {
  const data: Uint8Array[] = [];
  let [number, before] = [first, FILE_START];
  for (;;) {
    const chunk = flash.subarray((number - 1) * CHUNK_BYTES, number * CHUNK_BYTES);
    if (chunk[0] !== before || data.length >= count) return null;
    data.push(chunk.subarray(1, -1));
    const next = chunk[CHUNK_BYTES - 1] ?? LAST;
    if (next === LAST) break;
    if (next < 1 || next > count) return null;
    [number, before] = [next, number];
  }
  const all = new Uint8Array(data.length * DATA_BYTES);
  for (const [index, piece] of data.entries()) all.set(piece, index * DATA_BYTES);
  const [endOffset = 0, nameBytes = 0] = all;
  const [start, end] = [HEADER_BYTES + nameBytes, (data.length - 1) * DATA_BYTES + endOffset];
  if (endOffset > DATA_BYTES || start > end || end > all.length) return null;
  return { name: new TextDecoder().decode(all.subarray(HEADER_BYTES, start)), bytes: all.slice(start, end) };
}

/** The script that the first editors put behind everything else; `null`: there is none. */
export function appendedScript(regions: readonly Region[]): Uint8Array | null {
  const [m, p, low = 0, high = 0] = bytesAt(regions, APPENDED, APPENDED_HEADER);
  const length = 256 * high + low;
  if (m !== 0x4d || p !== 0x50 || length > APPENDED_BYTES - APPENDED_HEADER) return null;
  return bytesAt(regions, APPENDED + APPENDED_HEADER, length);
}

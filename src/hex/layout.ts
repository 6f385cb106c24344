import type { Region } from './firmware';
import { bytesAt, textAt, viewOf, wordAt } from './memory';

/** The places of things in the flash of a board with MicroPython: addresses, the ends exclusive. */
export interface Layout {
  /** An nRF51 with 256 KiB of flash; otherwise an nRF52 with 512 KiB. */
  readonly isOldChip: boolean;
  readonly pageBytes: number;
  readonly runtimeEnd: number;
  /** The space for files with the page that the board keeps for its own use. */
  readonly filesStart: number;
  readonly filesEnd: number;
  /** The end of everything that a run may have written there. */
  readonly dataEnd: number;
  readonly version: string;
}

export const CHUNK_BYTES = 128;
/** A link to a chunk is one byte, of which four values mean something else. */
export const MOST_CHUNKS = 252;

/** The block in which old firmwares say how the flash is divided: `uicr.ts` of microbit-fs 0.10.0. */
const UICR = 0x100010c0;
const UICR_MAGIC = 0x17eeb07c;
const UICR_MAGIC_BETA = 0x47eeb07c;

/** The table at the end of a page, read upwards: `addlayouttable.py` of micropython-microbit-v2. */
const PAGE = 0x1000;
const FLASH = 0x80000;
const ROW_BYTES = 16;
const TABLE_MAGIC = [0x597f30fe, 0xc1b1d79d] as const;
const MICROPYTHON = 2;
const FILES = 3;
const POINTER = 2;
/** Chosen: three rows are known. */
const MOST_ROWS = 16;

/** The place of an appended script, 8 KiB, in the first firmwares. */
export const APPENDED = 0x3e000;
const OLD_FLASH = 0x40000;
const OLD_PAGE = 0x400;

/** The layout of a board's flash; `null`: there is no MicroPython with files in it. */
export function layoutOf(regions: readonly Region[]): Layout | null {
  const layout = oldLayout(regions) ?? tableLayout(regions);
  const isUsable = layout !== null && layout.filesStart % layout.pageBytes === 0 && roomOf(layout) > 0;
  return isUsable ? layout : null;
}

function oldLayout(regions: readonly Region[]): Layout | null {
  const view = viewOf(bytesAt(regions, UICR, 28));
  const magic = view.getUint32(0, true);
  if (magic !== UICR_MAGIC && magic !== UICR_MAGIC_BETA) return null;
  const isOldChip = magic === UICR_MAGIC;
  const pageBytes = isOldChip ? OLD_PAGE : PAGE;
  const runtimeEnd = view.getUint16(14, true) * pageBytes;
  const dataEnd = isOldChip ? OLD_FLASH : 0x73000;
  if (1 << view.getUint32(8, true) !== pageBytes || runtimeEnd === 0 || runtimeEnd >= dataEnd) return null;
  const flashEnd = isOldChip && hasAppended(regions) ? APPENDED : dataEnd;
  // The old chip keeps the compass's calibration in the page behind the files.
  const filesEnd = isOldChip ? flashEnd - pageBytes : flashEnd;
  return {
    ...{ isOldChip, pageBytes, runtimeEnd, filesEnd, dataEnd },
    filesStart: startOf(runtimeEnd, filesEnd),
    version: textAt(regions, view.getUint32(20, true)),
  };
}

function tableLayout(regions: readonly Region[]): Layout | null {
  const end = tableEnd(regions);
  if (end === null) return null;
  const header = end - ROW_BYTES;
  const count = Math.min(MOST_ROWS, viewOf(bytesAt(regions, header, ROW_BYTES)).getUint16(8, true));
  let files: { readonly start: number; readonly bytes: number } | null = null;
  let version: string | null = null;
  for (let row = 1; row <= count; row++) {
    const view = viewOf(bytesAt(regions, header - row * ROW_BYTES, ROW_BYTES));
    const id = view.getUint8(0);
    if (id === MICROPYTHON) version = view.getUint8(1) === POINTER ? textAt(regions, view.getUint32(8, true)) : '';
    if (id === FILES) files = { start: view.getUint16(2, true) * PAGE, bytes: view.getUint32(4, true) };
  }
  if (files === null || version === null) return null;
  const filesEnd = files.start + files.bytes;
  if (files.start < end || filesEnd > FLASH || files.bytes < 2 * PAGE || files.bytes % PAGE !== 0) return null;
  return {
    ...{ isOldChip: false, pageBytes: PAGE, runtimeEnd: end, filesEnd, dataEnd: filesEnd, version },
    filesStart: startOf(files.start, filesEnd),
  };
}

/** The files begin higher up if there is more room than they can be numbered for. */
const startOf = (start: number, end: number): number => Math.max(start, end - CHUNK_BYTES * MOST_CHUNKS);

/** The end of the page with the table. */
function tableEnd(regions: readonly Region[]): number | null {
  for (let end = PAGE; end <= FLASH; end += PAGE) {
    const isHere = wordAt(regions, end - ROW_BYTES) === TABLE_MAGIC[0] && wordAt(regions, end - 4) === TABLE_MAGIC[1];
    if (isHere) return end;
  }
  return null;
}

/** True if a script of the old form lies behind everything else. */
export function hasAppended(regions: readonly Region[]): boolean {
  const [first, second] = bytesAt(regions, APPENDED, 2);
  return first === 0x4d && second === 0x50;
}

/** The bytes for files: one page is the board's own. */
export const roomOf = ({ filesStart, filesEnd, pageBytes }: Layout): number => filesEnd - filesStart - pageBytes;

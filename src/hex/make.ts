import { storedBytes, writtenFiles, type StoredFile } from './file-system';
import type { Firmware, HexBoard } from './firmware';
import type { FileSize, HexFile, MadeHex } from './hex';
import { layoutOf } from './layout';
import { CUSTOM_DATA, DATA, dataRecords, LAST_LINE } from './records';
import { universalHex } from './universal';

/** Longest name that the board's file system holds, in bytes. */
const NAME_BYTES = 120;

/** Sets the upper half of the address to 0, which it is anyway. */
const FIRST_LINE = ':020000040000FA\n';

/** The numbers of boards in a universal hex: a Calliope mini has those of the micro:bit with its chip. */
const OLD_ID = 0x9900;
const NEW_ID = 0x9903;

/**
 * Writes files beside the firmware of a board: a hex for it, or a universal one for two boards of one family.
 * An empty file gets a line end, since the board's file system holds none that is empty.
 */
export function makeHex(firmwares: readonly Firmware[], files: readonly HexFile[]): MadeHex {
  const sorted = firmwares.toSorted((a, b) => Number(isNew(a.board)) - Number(isNew(b.board)));
  const boards = sorted.map(({ board }) => board);
  if (!areTogether(boards)) return { kind: 'boards', boards };
  const names = files.map(({ name }) => name);
  const wrong = names.find((name, place) => !isName(name) || names.indexOf(name) !== place);
  if (wrong !== undefined) return { kind: 'name', name: wrong };
  const contents = files.map(({ name, text }) => ({ name, bytes: new TextEncoder().encode(text === '' ? '\n' : text) })); // prettier-ignore
  const sizes = contents.map(({ name, bytes }) => ({ name, bytes: storedBytes(name, bytes) }));
  const usedBytes = sizes.reduce((sum, { bytes }) => sum + bytes, 0);
  const roomBytes = Math.min(...sorted.map((firmware) => firmware.roomBytes));
  if (usedBytes > roomBytes) return { ...{ kind: 'too-large', missingBytes: usedBytes - roomBytes, roomBytes }, large: largest(sizes) }; // prettier-ignore
  const filled = files.filter(({ text }) => text === '').map(({ name }) => name);
  return { kind: 'hex', text: textOf(sorted, contents), boards, usedBytes, roomBytes, filled };
}

/** One board's as it is, two as one file: the old chip's first, since apps know the file by that. */
function textOf(firmwares: readonly Firmware[], files: readonly StoredFile[]): string {
  const [only, another] = firmwares;
  if (only !== undefined && another === undefined) {
    const records = recordsOf(only, files, DATA);
    // Calliope's app for Android takes a file that begins with this line for one of a Calliope mini 1 or 2.
    const isMistaken = only.board === 'calliope-mini-3' && records.startsWith(FIRST_LINE);
    return (isMistaken ? records.slice(FIRST_LINE.length) : records) + LAST_LINE;
  }
  return universalHex(
    firmwares.map((firmware) =>
      isNew(firmware.board)
        ? { boardId: NEW_ID, records: recordsOf(firmware, files, CUSTOM_DATA) }
        : { boardId: OLD_ID, records: recordsOf(firmware, files, DATA) },
    ),
  );
}

function recordsOf({ regions, board }: Firmware, files: readonly StoredFile[], type: number): string {
  const layout = layoutOf(regions);
  if (layout === null) throw new Error(`The firmware for ${board} does not say where files go.`);
  const runtime = regions.filter(({ address }) => address < layout.runtimeEnd);
  const rest = [...regions.filter(({ address }) => address >= layout.runtimeEnd), ...writtenFiles(files, layout)];
  // Apart, so that the files begin with an address of their own, as other editors write it.
  return dataRecords(runtime, type) + dataRecords(rest.toSorted((a, b) => a.address - b.address), type); // prettier-ignore
}

const isNew = (board: HexBoard): boolean => board === 'microbit-v2' || board === 'calliope-mini-3';
const isCalliope = (board: HexBoard): boolean => board.startsWith('calliope');

/** True for one board, or an old and a new one of the same family. */
function areTogether([one, other, third]: readonly HexBoard[]): boolean {
  if (one === undefined || third !== undefined) return false;
  return other === undefined || (isCalliope(one) === isCalliope(other) && isNew(one) !== isNew(other));
}

const isName = (name: string): boolean => name !== '' && new TextEncoder().encode(name).length <= NAME_BYTES;

const largest = (sizes: readonly FileSize[]): readonly FileSize[] => sizes.toSorted((a, b) => b.bytes - a.bytes);

import { MicropythonFsHex } from '@microbit/microbit-fs';
import { createUniversalHex, microbitBoardId } from '@microbit/microbit-universal-hex';
import MemoryMap from 'nrf-intel-hex';
import { storedBytes } from './file-system';
import type { Firmware, HexBoard } from './firmware';
import type { FileSize, HexFile, MadeHex } from './hex';

/** Longest name that the board's file system holds, in bytes. */
const NAME_BYTES = 120;

/** Sets the upper half of the address to 0, which it is anyway. */
const FIRST_LINE = /^:020000040000FA\r?\n/i;

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
  const contents = files.map(({ name, text }) => ({ name, bytes: bytesOf(text === '' ? '\n' : text) }));
  const sizes = contents.map(({ name, bytes }) => ({ name, bytes: storedBytes(name, bytes) }));
  const usedBytes = sizes.reduce((sum, { bytes }) => sum + bytes, 0);
  const roomBytes = Math.min(...sorted.map((firmware) => firmware.roomBytes));
  if (usedBytes > roomBytes) return { ...{ kind: 'too-large', missingBytes: usedBytes - roomBytes, roomBytes }, large: largest(sizes) }; // prettier-ignore
  const parts = sorted.map((firmware) => ({ firmware, hex: withFiles(firmware, contents) }));
  const filled = files.filter(({ text }) => text === '').map(({ name }) => name);
  return { kind: 'hex', text: textOf(parts), boards, usedBytes, roomBytes, filled };
}

type Part = { readonly firmware: Firmware; readonly hex: string };

/** One part as it is, two as one file: the old chip's first, under the number that every reader knows. */
function textOf(parts: readonly Part[]): string {
  const [only, another] = parts;
  if (only === undefined) return '';
  // Calliope's app for Android takes a file that begins with this line for one of a Calliope mini 1 or 2.
  if (another === undefined) return only.firmware.board === 'calliope-mini-3' ? only.hex.replace(FIRST_LINE, '') : only.hex; // prettier-ignore
  return createUniversalHex(
    parts.map(({ firmware, hex }) => ({
      hex,
      boardId: isNew(firmware.board) ? microbitBoardId.V2 : microbitBoardId.V1,
    })),
  );
}

interface Content {
  readonly name: string;
  readonly bytes: Uint8Array;
}

function withFiles({ regions }: Firmware, files: readonly Content[]): string {
  const memory = new MemoryMap(regions.map(({ address, bytes }) => [address, bytes]));
  const hex = new MicropythonFsHex(memory.asHexString());
  for (const { name, bytes } of files) hex.create(name, bytes);
  return hex.getIntelHex();
}

/** The library asks whose class its bytes are of, and an encoder may have another one than the page. */
const bytesOf = (text: string): Uint8Array => Uint8Array.from(new TextEncoder().encode(text));

const isNew = (board: HexBoard): boolean => board === 'microbit-v2' || board === 'calliope-mini-3';
const isCalliope = (board: HexBoard): boolean => board.startsWith('calliope');

/** True for one board, or an old and a new one of the same family. */
function areTogether([one, other, third]: readonly HexBoard[]): boolean {
  if (one === undefined || third !== undefined) return false;
  return other === undefined || (isCalliope(one) === isCalliope(other) && isNew(one) !== isNew(other));
}

const isName = (name: string): boolean => name !== '' && new TextEncoder().encode(name).length <= NAME_BYTES;

const largest = (sizes: readonly FileSize[]): readonly FileSize[] => sizes.toSorted((a, b) => b.bytes - a.bytes);

import { sha256 } from '@noble/hashes/sha2.js';
import { bytesToHex } from '@noble/hashes/utils.js';

import type { Firmware } from '#hex/firmware';

import type { ZippedFile } from '../../../session/work/zip';
import type { HexWriter } from '../board/hex-writer';
import { FOLDER, LIST, type HostFirmware } from './host-firmware';
import notice from './notice.txt?raw';

/** The folder that a host puts beside the app: these firmwares, the list of them, and the notice that goes with them. */
export async function serverFolder(firmwares: readonly Firmware[], write: HexWriter): Promise<readonly ZippedFile[]> {
  const hexes = await Promise.all(
    firmwares.map(async (firmware) => ({ board: firmware.board, text: await bareHex(firmware, write) })),
  );
  const listed = hexes.map(({ board, text }): HostFirmware => {
    return { board, file: fileOf(board), sha256: bytesToHex(sha256(new TextEncoder().encode(text))) };
  });
  const files = [
    { name: LIST, text: `${JSON.stringify({ firmwares: listed }, null, 2)}\n` },
    { name: 'NOTICE.txt', text: notice },
    ...hexes.map(({ board, text }) => ({ name: fileOf(board), text })),
  ];
  return files.map(({ name, text }) => ({ name: FOLDER + name, text }));
}

const fileOf = (board: string): string => `micropython-${board}.hex`;

async function bareHex(firmware: Firmware, write: HexWriter): Promise<string> {
  const made = await write([firmware], []);
  if (made.kind !== 'hex') throw new Error(`No hex can be made for ${firmware.board}.`);
  return made.text;
}

import { sha256 } from '@noble/hashes/sha2.js';
import { bytesToHex } from '@noble/hashes/utils.js';

import type { Firmware } from '#hex/firmware';
import { makeHex } from '#hex/make';

import type { ZippedFile } from '../../../session/work/zip';
import { FOLDER, LIST, type HostFirmware } from './host-firmware';
import notice from './notice.txt?raw';

/** The folder that a host puts beside the app: these firmwares, the list of them, and the notice that goes with them. */
export function serverFolder(firmwares: readonly Firmware[]): readonly ZippedFile[] {
  const hexes = firmwares.map((firmware) => ({ board: firmware.board, text: bareHex(firmware) }));
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

function bareHex(firmware: Firmware): string {
  const made = makeHex([firmware], []);
  if (made.kind !== 'hex') throw new Error(`No hex can be made for ${firmware.board}.`);
  return made.text;
}

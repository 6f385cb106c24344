import type { Firmware, HexBoard } from '#hex/firmware';

import { inStore, type Table } from '../../../session/work/storage/database';

/** The MicroPython of a board, as it is kept in this browser. */
export interface KeptFirmware {
  /** The board, by which it is found. */
  readonly name: HexBoard;
  readonly firmware: Firmware;
  /** SHA-256 of the web server's file from which it was made; `null`: somebody has given it. */
  readonly sum: string | null;
}

const TABLE: Table = { database: 'parcours-firmware', store: 'boards' };

/** The firmwares that are kept in this browser; none where it has no database. */
export async function keptFirmwares(): Promise<readonly KeptFirmware[]> {
  let kept: readonly KeptFirmware[] = [];
  try {
    await inStore(
      'readonly',
      (store) => {
        const request = store.getAll(IDBKeyRange.bound('a', 'z')) as IDBRequest<KeptFirmware[]>;
        request.onsuccess = () => (kept = request.result);
      },
      TABLE,
    );
  } catch {
    // A frame without storage: they last until the page is closed.
  }
  return kept;
}

/** Keeps firmwares in place of earlier ones of the same boards. @returns false where the browser takes nothing */
export async function keepFirmwares(list: readonly KeptFirmware[]): Promise<boolean> {
  try {
    await inStore('readwrite', (store) => list.forEach((kept) => store.put(kept)), TABLE);
    return true;
  } catch {
    return false;
  }
}

/** Removes the firmware of a board, if there is one. */
export async function removeFirmware(board: HexBoard): Promise<void> {
  try {
    await inStore('readwrite', (store) => store.delete(board), TABLE);
  } catch {
    // There is no database, so there is nothing in it.
  }
}

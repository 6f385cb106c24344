/**
 * The store for pieces of stored work (`pieces.ts`): IndexedDB, which holds far more than the browser's storage for
 * text.
 */
import { inStore, type Entry } from './database';
import { DISK_COPY } from './disk-copy';
import type { Piece } from './pieces';

/** Pieces that were not used for this long are deleted. Chosen: a year of school and its holidays. */
const FORGOTTEN_MS = 400 * 24 * 3600 * 1000;

/** Stores pieces; done once they are on the disk. Rejects where the browser has no such store or no room. */
export async function putPieces(pieces: readonly Piece[], nowMs: number): Promise<void> {
  await inStore('readwrite', (store) => {
    for (const piece of pieces) store.put({ ...piece, usedMs: nowMs } satisfies Entry);
  });
}

/** The pieces of these names, as far as they exist. Those that were not used for a long time are deleted. */
export async function getPieces(names: readonly string[], nowMs: number): Promise<ReadonlyMap<string, string>> {
  const found = new Map<string, string>();
  await inStore('readwrite', (store) => {
    for (const name of new Set(names)) {
      const request = store.get(name) as IDBRequest<Entry | undefined>;
      request.onsuccess = () => {
        if (request.result === undefined) return;
        found.set(name, request.result.text);
        store.put({ ...request.result, usedMs: nowMs });
      };
    }
    const old = store.index('used').openKeyCursor(IDBKeyRange.upperBound(nowMs - FORGOTTEN_MS));
    old.onsuccess = () => {
      if (old.result === null) return;
      const { primaryKey } = old.result;
      const isPiece = typeof primaryKey === 'string' && !primaryKey.startsWith(DISK_COPY);
      if (isPiece && !names.includes(primaryKey)) store.delete(primaryKey);
      old.result.continue();
    };
  });
  return found;
}

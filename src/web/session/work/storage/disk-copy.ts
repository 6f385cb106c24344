/**
 * Copies of the tabs' work in the browser's database. What goes to the storage for text survives the tab at once, but is
 * written to the disk some seconds later; these copies are on the disk when they are done, and survive the browser, too.
 */
import { entriesIn } from './database';

/** Before the name of the tab. The pieces, which lie in the same store, have other names (`pieces.ts`). */
export const DISK_COPY = 'work.';

/** All copies. */
export const allCopies = (): IDBKeyRange => IDBKeyRange.bound(DISK_COPY, `${DISK_COPY}~`);

/** The last copy of this tab, or the newest of all tabs for `null`; `null` if there is none. */
export async function copyOnDisk(tab: string | null): Promise<string | null> {
  const found = await entriesIn(tab === null ? allCopies() : DISK_COPY + tab);
  return [...found].sort((one, other) => other.usedMs - one.usedMs)[0]?.text ?? null;
}

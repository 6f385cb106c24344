/** Writes the copies of `disk-copy.ts`. */
import { inStore, type Entry } from './database';
import { DISK_COPY } from './disk-copy';

/** Puts text onto the disk. Returns whether the newest text is there. */
export type DiskWriter = (text: string, savedMs: number) => Promise<boolean>;

/**
 * The writer of a tab. It writes one text after the other, and of those that wait only the newest: a slow disk is not asked
 * for more than it can do.
 */
export function createDiskWriter(tab: string): DiskWriter {
  let next: Entry | null = null;
  let writing: Promise<boolean> | null = null;
  async function write(): Promise<boolean> {
    let isWritten = false;
    while (next !== null) {
      const entry: Entry = next;
      next = null;
      isWritten = await put(entry).then(
        () => true,
        () => false,
      );
    }
    writing = null;
    return isWritten;
  }
  return (text, savedMs) => {
    next = { name: DISK_COPY + tab, text, usedMs: savedMs };
    return (writing ??= write());
  };
}

const put = (entry: Entry): Promise<void> => inStore('readwrite', (store) => void store.put(entry));

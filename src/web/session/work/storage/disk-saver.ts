/**
 * The part of saving that is loaded late, with the first change: writing to the disk, and storing large parts of the
 * work.
 */
import { createDiskWriter } from './disk-writer';
import { savedMsOf, type Work } from './history';
import { dropDoubled } from './copies';
import { LargeWork } from './large-work';

export { wholeWork } from './large-work';

/**
 * From this length of the work on (characters), its large parts are stored apart: a picture as floor, large earlier
 * work.
 */
const LARGE = 100_000;

/** `again`: large parts were put apart, and the rest is to be saved without them. */
export type Kept = 'again' | 'kept' | 'lost';

/** Saves the work of a tab to the disk. */
export interface DiskSaver {
  /** The work as text, without the parts that lie apart. */
  textOf(work: Work): string;
  /**
   * @param text the work as it was put into the storage for text just now
   * @param isSaved whether that storage has taken it
   */
  keep(work: Work, text: string, isSaved: boolean): Promise<Kept>;
}

/** Makes the saver of the tab of this name. */
export function createDiskSaver(tab: string): DiskSaver {
  const write = createDiskWriter(tab);
  const large = new LargeWork();
  return {
    textOf: (work) => large.textOf(work),
    async keep(work, text, isSaved) {
      const savedMs = savedMsOf(text);
      const isWritten = write(text, savedMs);
      // Until its large parts are apart they stay with the work, so that a crash meanwhile costs nothing.
      if (text.length >= LARGE || !isSaved) {
        const isSmaller = await large.setApart(work, savedMs).catch(() => false);
        if (isSmaller) return 'again';
      }
      if (!isSaved && (await dropDoubled(tab).catch(() => false))) return 'again';
      return isSaved || (await isWritten) ? 'kept' : 'lost';
    },
  };
}

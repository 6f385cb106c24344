import type { Work } from './history';
import { getPieces, putPieces } from './piece-store';
import { joinWork, piecesIn, splitWork } from './pieces';

/** Work that is too large for the browser's storage for text: its large parts lie in the store for pieces. */
export class LargeWork {
  private readonly kept = new Set<string>();

  /** The work as text, without the parts that lie apart by now. */
  textOf(work: Work): string {
    return splitWork(work, (name) => this.kept.has(name)).text;
  }

  /**
   * Puts the large parts of the work into their store.
   *
   * @returns whether there were any that were not there yet; rejects where the browser has no room or no such store
   */
  async setApart(work: Work, nowMs: number): Promise<boolean> {
    const { loose } = splitWork(work, (name) => this.kept.has(name));
    if (loose.length === 0) return false;
    await putPieces(loose, nowMs);
    for (const { name } of loose) this.kept.add(name);
    return true;
  }
}

/** Stored work with its pieces where they belong; without those that are lost it opens with a bare floor. */
export async function wholeWork(text: string, nowMs: number): Promise<string> {
  const pieces = await getPieces(piecesIn(text), nowMs).catch(() => new Map<string, string>());
  return joinWork(text, pieces);
}

import { ABSENT, Codes } from './codes';
import { writeChunk } from './chunk';
import { LeafTree } from './leaves';

/** Moments in a piece: 5 s. Chosen: one is packed and unpacked in a few ms, and what all repeat is a small part of it. */
const MOMENTS = 250;

/** Takes moment after moment and makes pieces of the tape of them. The first can be read without any other; the others need those before. */
export class RowWriter {
  private readonly tree = new LeafTree();
  private readonly codes = new Codes();
  /** By column. */
  private series: number[][] = [];
  private moments = 0;
  private toldColumns = 0;
  private toldValues = 0;

  /**
   * Adds what a moment shows: plain data with its `timeUs`, later than the moment before.
   *
   * @returns the piece that it has filled, or `null`
   */
  add(moment: { readonly timeUs: number }): Uint8Array | null {
    const { tree, codes, series, moments } = this;
    tree.walk(moment, (column, leaf) => {
      const own = (series[column] ??= []);
      while (own.length < moments) own.push(ABSENT);
      own.push(codes.of(leaf, tree.columns[column]?.step ?? 1));
    });
    this.moments++;
    return this.moments === MOMENTS ? this.finish() : null;
  }

  /** The piece with what has been added since the last one; `null` where that is nothing. */
  finish(): Uint8Array | null {
    const { tree, codes, series, moments } = this;
    if (moments === 0) return null;
    const columns = tree.columns.map((_, column) => {
      const own = series[column] ?? [];
      while (own.length < moments) own.push(ABSENT);
      return own;
    });
    const piece = writeChunk({
      isFirst: this.toldColumns === 0,
      newColumns: tree.columns.slice(this.toldColumns),
      newValues: codes.values.slice(this.toldValues),
      moments,
      columns,
    });
    this.toldColumns = tree.columns.length;
    this.toldValues = codes.values.length;
    this.series = [];
    this.moments = 0;
    return piece;
  }
}

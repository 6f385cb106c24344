import { dataOfMoment, NOTHING_KNOWN, readChunk, timesOf, writeChunk, type Chunk, type KnownContent } from './chunk';

/** A piece with what is needed to read it again. */
interface Piece {
  readonly bytes: Uint8Array;
  readonly fromUs: number;
  readonly toUs: number;
  /** The content of the pieces before it. */
  readonly before: KnownContent;
  /** One of this many moments is left. */
  readonly thinned: number;
}

/** Number of pieces in memory unpacked: the one that is looked at, and its neighbours. */
const UNPACKED = 3;

/** The newest pieces, which are never thinned: the last minute is what people look at. */
const WHOLE = 12;

/** The moments of a tape, to be looked up by time. */
export class Rows<Moment extends { readonly timeUs: number }> {
  private pieces: readonly Piece[] = [];
  private told: KnownContent = NOTHING_KNOWN;
  private unpacked = new Map<Piece, Chunk>();

  /** @param mostBytes above this the oldest pieces lose every second moment, again and again; left out: never. The last
   *   minute stays whole, even where it alone is larger */
  constructor(private readonly mostBytes = Infinity) {}

  /**
   * Adds the next piece of a `RowWriter`.
   *
   * @returns its content, or `null` if it is no such piece; the rows then stay the same
   */
  push(bytes: Uint8Array): Chunk | null {
    const chunk = readChunk(bytes, this.told);
    const times = chunk && timesOf(chunk);
    if (!chunk || !times || (times[0] ?? 0) <= this.endUs) return null;
    const before = chunk.isFirst ? NOTHING_KNOWN : this.told;
    const span = { fromUs: times[0] ?? 0, toUs: times.at(-1) ?? 0 };
    this.pieces = [...this.pieces, { bytes, ...span, before, thinned: 1 }];
    this.told = { columns: chunk.columns, values: chunk.values };
    while (this.bytes > this.mostBytes && this.thinOldest());
    return chunk;
  }

  /** The size of all pieces. */
  get bytes(): number {
    return this.pieces.reduce((sum, { bytes }) => sum + bytes.length, 0);
  }

  /** The time of the last moment; −1 while there is none. */
  get endUs(): number {
    return this.pieces.at(-1)?.toUs ?? -1;
  }

  /** The last moment at or before a time, or the first one; `null` while there is none. */
  at(timeUs: number): Moment | null {
    const piece = this.pieces.findLast(({ fromUs }) => fromUs <= timeUs) ?? this.pieces[0];
    const chunk = piece && this.chunkOf(piece);
    if (!chunk) return null;
    const moment = timesOf(chunk)?.findLastIndex((us) => us <= timeUs) ?? 0;
    return dataOfMoment(chunk, Math.max(moment, 0)) as Moment;
  }

  private chunkOf(piece: Piece): Chunk | null {
    const known = this.unpacked.get(piece);
    if (known) return known;
    const chunk = readChunk(piece.bytes, piece.before);
    if (!chunk) return null;
    if (this.unpacked.size >= UNPACKED) this.unpacked.delete([...this.unpacked.keys()][0] ?? piece);
    this.unpacked.set(piece, chunk);
    return chunk;
  }

  /**
   * Takes every second moment out of the oldest of the pieces that have lost least; the newest stay whole.
   *
   * @returns whether one could lose some
   */
  private thinOldest(): boolean {
    const old = this.pieces.slice(0, -WHOLE);
    const least = Math.min(...old.map(({ thinned }) => thinned));
    const at = old.findIndex(({ thinned }) => thinned === least);
    const piece = old[at];
    const chunk = piece && readChunk(piece.bytes, piece.before);
    if (!chunk || chunk.moments < 3) return false;
    this.pieces = this.pieces.with(at, { ...piece, bytes: thinner(chunk, piece), thinned: piece.thinned * 2 });
    this.unpacked.delete(piece);
    return true;
  }
}

function thinner(chunk: Chunk, { before }: Piece): Uint8Array {
  const stays = (_: unknown, moment: number): boolean => moment % 2 === 0 || moment === chunk.moments - 1;
  const columns = chunk.codes.map((codes) => codes.filter(stays));
  return writeChunk({
    isFirst: chunk.isFirst,
    newColumns: chunk.columns.slice(before.columns.length),
    newValues: chunk.values.slice(before.values.length),
    moments: columns[0]?.length ?? 0,
    columns,
  });
}

/**
 * The bytes of a link (`link.ts`), by its version:
 *
 *     1   length of the deflated figures (3 bytes, lowest first), figures and words (`columns.ts`), each deflated (RFC 1951)
 *     2   the values one after the other, arithmetically coded by how likely a model finds them (`model-coder.ts`)
 *
 *     3   for a task with more than rules: 1 or 2 as a byte, then as in that version
 *     4   for a robot of one's own: as 3, with that robot
 *     5   for several devices: as 4, with those after the first
 *     6   for starts of further robots in the course, and a task that they share: as 5, with those
 *     7   for any angle, round bodies, polygons, locks and groups: as 6, with those
 *     8   for the name and the colour of the first robot: as 7, with those
 *     9   for a task for a class, or what is handed in: as 8, with that
 *     10  for heights of things: as 9, with those
 *     11  for colours of fields and things, and all that `#scene/news` names: as 10, with that
 *
 * `link-content.ts` and `scene-codec.ts` define the values and their order. Content that is too large for a model uses
 * the way of version 1.
 */
import { packed, unpacked } from '#core/deflate';
import { ColumnReader, ColumnWriter, type Bytes } from './columns';
import { DamagedBytes } from './damaged-bytes';
import {
  deflatedContent,
  laterVersions,
  modelledContent,
  type Content,
  type ContentCodec,
  type Packing,
} from './link-content';
import { MODELLED_BYTES, ModelReader, ModelWriter, TooManyBytes } from './model-coder';
import { LIKELY_WORDS } from './likely-text';

/** The most a link may unpack to, in bytes. */
export const UNPACKED_BYTES = 4 * 1024 * 1024;

/** A link's bytes and their meaning. */
export interface LinkBytes {
  readonly version: 1 | 2 | keyof typeof laterVersions;
  readonly bytes: Uint8Array;
}

const plain: Packing = { deflated: deflatedContent, modelled: modelledContent };
/** The bytes of a content, or `null` when they would unpack to more than `UNPACKED_BYTES`. */
export function bytesOfContent(content: Content): LinkBytes | null {
  const version = versionFor(content);
  const { way, bytes } = packedContent(content, version === null ? plain : laterVersions[version]) ?? {};
  if (way === undefined || bytes === undefined) return null;
  return version === null ? { version: way, bytes } : { version, bytes: Uint8Array.from([way, ...bytes]) };
}

/** The oldest version that can say it all; `null`: one of the first two. */
function versionFor(content: Content): keyof typeof laterVersions | null {
  const { extras, myRobot, devices, starts, sharing, additions, firstRobot, carried, heights, news } = content;
  if (news !== '') return 11;
  if (heights.length > 0) return 10;
  if (carried !== '') return 9;
  if (firstRobot !== null) return 8;
  if (additions.length > 0) return 7;
  if (starts.length > 0 || sharing !== null) return 6;
  if (devices !== null) return 5;
  if (myRobot !== '') return 4;
  return Object.keys(extras).length > 0 ? 3 : null;
}

function packedContent(content: Content, packing: Packing): { way: 1 | 2; bytes: Uint8Array } | null {
  const columns = new ColumnWriter();
  packing.deflated.codec.write(columns, content);
  const inColumns = columns.bytes();
  const length = inColumns.figures.length + inColumns.words.length;
  if (length > UNPACKED_BYTES) return null;
  if (length > MODELLED_BYTES) return { way: 1, bytes: deflatedBytes(inColumns) };
  const modelled = new ModelWriter();
  packing.modelled.codec.write(modelled, content);
  return { way: 2, bytes: modelled.bytes() };
}

/** How much several links may still unpack to together, in bytes: each that is read takes from it, even below 0. */
export interface Room {
  left: number;
}

/** The content of the bytes; never throws. @param room what is unpacked is taken from it */
export function contentOfBytes({ version, bytes }: LinkBytes, room: Room): Content | 'damaged' | 'too-large' {
  try {
    const isPlain = version === 1 || version === 2;
    const { deflated, modelled } = isPlain ? plain : laterVersions[version];
    const way = isPlain ? version : bytes[0];
    const rest = isPlain ? bytes : bytes.subarray(1);
    if (way === 1) return contentOfColumns(rest, deflated, room);
    return way === 2 ? contentOfModel(rest, modelled, room) : 'damaged';
  } catch (error) {
    if (error instanceof DamagedBytes) return 'damaged';
    if (error instanceof TooManyBytes) return 'too-large';
    throw error;
  }
}

function contentOfModel(bytes: Uint8Array, { codec }: ContentCodec, room: Room): Content | 'damaged' {
  const reader = new ModelReader(bytes);
  try {
    const content = codec.read(reader);
    return reader.isAtEnd ? content : 'damaged';
  } finally {
    room.left -= MODELLED_BYTES - reader.left();
  }
}

function contentOfColumns(
  bytes: Uint8Array,
  { codec, columns: count }: ContentCodec,
  room: Room,
): Content | 'damaged' | 'too-large' {
  const columns = columnsOf(bytes);
  // How far something damaged was unpacked, nobody knows.
  room.left -= typeof columns === 'string' ? UNPACKED_BYTES : columns.figures.length + columns.words.length;
  if (typeof columns === 'string') return columns;
  const reader = new ColumnReader(columns, count);
  const content = codec.read(reader);
  return reader.isAtEnd ? content : 'damaged';
}

const LENGTH_BYTES = 3;

/** Columns in the form of a link of version 1. */
export function deflatedBytes({ figures, words }: Bytes): Uint8Array {
  const [deflated, deflatedWords] = [packed(figures), packed(words, LIKELY_WORDS)];
  const all = new Uint8Array(LENGTH_BYTES + deflated.length + deflatedWords.length);
  all.set([deflated.length & 0xff, (deflated.length >>> 8) & 0xff, deflated.length >>> 16]);
  all.set(deflated, LENGTH_BYTES);
  all.set(deflatedWords, LENGTH_BYTES + deflated.length);
  return all;
}

/** Separates what `deflatedBytes` combined; both parts together stay within the limit. */
function columnsOf(all: Uint8Array): Bytes | 'damaged' | 'too-large' {
  const [low = 0, middle = 0, high = 0] = all;
  const end = LENGTH_BYTES + (low | (middle << 8) | (high << 16));
  if (all.length <= end) return 'damaged';
  const figures = unpacked(all.subarray(LENGTH_BYTES, end), UNPACKED_BYTES);
  if (typeof figures === 'string') return figures;
  const words = unpacked(all.subarray(end), UNPACKED_BYTES - figures.length, LIKELY_WORDS);
  return typeof words === 'string' ? words : { figures, words };
}

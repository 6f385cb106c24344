import { unpacked } from '#core/deflate';
import { unread, type Unread } from '#check/hand-in/unread';
import { nameInZip } from './decode';

/** A file in a zip. */
export interface ZipEntry {
  /** With `/` between folders; one that ends with it is a folder. */
  readonly path: string;
  /** How large it is when it is unpacked, as the zip's directory says. */
  readonly size: number;
  /** Unpacks it; never more than so many bytes, whatever the zip says. */
  read(maxBytes: number): { readonly bytes: Uint8Array } | { readonly problem: Unread };
}

/** The files of a zip, or why it cannot be read. */
export type Zip = { readonly entries: readonly ZipEntry[] } | { readonly problem: Unread };

// APPNOTE.TXT 6.3.10 of PKWARE: sections 4.3.16, 4.3.12, 4.3.7.
const END = 0x06054b50;
const END_BYTES = 22;
const DIRECTORY = 0x02014b50;
const DIRECTORY_BYTES = 46;
const LOCAL = 0x04034b50;
const LOCAL_BYTES = 30;
const ENCRYPTED = 1;
const UTF_8 = 0x800;
const STORED = 0;
const DEFLATED = 8;
const ZIP64 = 0xffffffff;

/** Chosen: ten thousand hand-ins, and as many files beside them. */
const MOST_ENTRIES = 20_000;

/** Maximum number of folders around the content that are skipped. Chosen: more than anybody packs. */
const MOST_FOLDERS = 20;

/**
 * Reads the directory of a zip; its files are unpacked one by one when they are wanted. A zip in which two files lie at one
 * place is refused: with a few bytes it would name any number of large ones. Never throws.
 */
export function readZip(bytes: Uint8Array): Zip {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const end = endOf(view);
  if (end === null) return unread('zip');
  const [count, start] = [view.getUint16(end + 10, true), view.getUint32(end + 16, true)];
  if (count > MOST_ENTRIES) return unread('zip-many', { count, most: MOST_ENTRIES });
  const entries: ZipEntry[] = [];
  const places: Place[] = [];
  let at = start;
  for (let index = 0; index < count; index++) {
    const isThere = at + DIRECTORY_BYTES <= end && view.getUint32(at, true) === DIRECTORY;
    if (!isThere) return unread('zip-list');
    const [name, extra, comment] = [28, 30, 32].map((place) => view.getUint16(at + place, true));
    const path = withoutDots(textOf(bytes.subarray(at + DIRECTORY_BYTES, at + DIRECTORY_BYTES + (name ?? 0)), view.getUint16(at + 8, true))); // prettier-ignore
    const directory = at;
    const [packedBytes, size, local] = [20, 24, 42].map((place) => view.getUint32(directory + place, true));
    if (local !== ZIP64 && packedBytes !== ZIP64)
      places.push({ from: local ?? 0, to: (local ?? 0) + LOCAL_BYTES + (packedBytes ?? 0) });
    if (path !== '') entries.push({ path, size: size ?? 0, read: (maxBytes) => readEntry(bytes, view, directory, maxBytes) }); // prettier-ignore
    at += DIRECTORY_BYTES + (name ?? 0) + (extra ?? 0) + (comment ?? 0);
  }
  return overlap(places) ? unread('zip-twice') : { entries };
}

/** The place of a file in a zip: no byte of it belongs to another one. */
interface Place {
  readonly from: number;
  readonly to: number;
}

function overlap(places: readonly Place[]): boolean {
  const sorted = places.toSorted((a, b) => a.from - b.from);
  return sorted.some(({ from }, index) => from < (sorted[index - 1]?.to ?? 0));
}

/** The place of the record that ends the directory, before a comment of any length; `null`: there is none. */
function endOf(view: DataView): number | null {
  const first = Math.max(0, view.byteLength - END_BYTES - 0xffff);
  for (let at = view.byteLength - END_BYTES; at >= first; at--) if (view.getUint32(at, true) === END) return at;
  return null;
}

/** True for files that operating systems leave in folders; they are never hand-ins. */
export const isLitter = (name: string): boolean =>
  name.startsWith('.') || name.startsWith('~$') || LITTER.includes(name.toLowerCase());

/** Files and folders of Windows, macOS and Python. */
const LITTER: readonly string[] = ['thumbs.db', 'ehthumbs.db', 'desktop.ini', 'icon\r', '$recycle.bin', '__macosx', '__pycache__']; // prettier-ignore

/**
 * The content of a zip or a folder below common leading folders: packing a folder means its content.
 *
 * @param isWhole true if the folder `top` counts as a whole and stays; `below`: what lies in it
 */
export function belowFolders<T extends { readonly path: string }>(
  all: readonly T[],
  isWhole: (below: readonly T[], top: string) => boolean = () => false,
): readonly T[] {
  let entries = all;
  for (let level = 0; level < MOST_FOLDERS; level++) {
    const below = belowTop(entries);
    if (below === null || isWhole(below.entries, below.top)) break;
    ({ entries } = below);
  }
  return entries;
}

/** The folder that contains all files, and they below it; `null`: there is no such folder. */
function belowTop<T extends { readonly path: string }>(
  all: readonly T[],
): { readonly top: string; readonly entries: readonly T[] } | null {
  const entries = all.filter(({ path }) => !path.split('/').some(isLitter));
  const [top, another] = new Set(entries.map(({ path }) => path.split('/', 1)[0] ?? ''));
  if (top === undefined || another !== undefined || !entries.every(({ path }) => path.includes('/'))) return null;
  const below = entries.map((entry) => ({ ...entry, path: entry.path.slice(top.length + 1) }));
  return { top, entries: below.filter(({ path }) => path !== '') };
}

/** `./anna.py`, `/home/anna.py` and `../anna.py` lie in the zip like all others. */
function withoutDots(path: string): string {
  const names = path.split('/').filter((name) => !['', '.', '..'].includes(name));
  return names.join('/') + (path.endsWith('/') && names.length > 0 ? '/' : '');
}

/** A name as people write it, whatever system has packed it: a Mac parts ü into u and its dots. */
function textOf(bytes: Uint8Array, flags: number): string {
  const name = (flags & UTF_8) === 0 ? nameInZip(bytes) : new TextDecoder().decode(bytes);
  return name.replaceAll('\\', '/').normalize('NFC');
}

function readEntry(
  bytes: Uint8Array,
  view: DataView,
  directory: number,
  maxBytes: number,
): { readonly bytes: Uint8Array } | { readonly problem: Unread } {
  const [flags, method] = [view.getUint16(directory + 8, true), view.getUint16(directory + 10, true)];
  const [packedBytes, local] = [view.getUint32(directory + 20, true), view.getUint32(directory + 42, true)];
  if ((flags & ENCRYPTED) !== 0) return unread('zip-locked');
  if (packedBytes === ZIP64 || local === ZIP64) return unread('zip-large');
  if (local + LOCAL_BYTES > bytes.length || view.getUint32(local, true) !== LOCAL) return DAMAGED;
  const from = local + LOCAL_BYTES + view.getUint16(local + 26, true) + view.getUint16(local + 28, true);
  if (from + packedBytes > bytes.length) return DAMAGED;
  const content = bytes.subarray(from, from + packedBytes);
  if (method === STORED) return content.length > maxBytes ? tooLarge(maxBytes) : { bytes: content };
  if (method !== DEFLATED) return unread('zip-way', { method });
  if (content.length === 0) return DAMAGED;
  const whole = unpacked(content, maxBytes);
  if (whole === 'too-large') return tooLarge(maxBytes);
  return whole === 'damaged' ? DAMAGED : { bytes: whole };
}

const DAMAGED = unread('zip-file');
const tooLarge = (most: number) => unread('zip-bomb', { most });

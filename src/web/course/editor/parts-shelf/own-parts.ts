import { shallowRef, type ShallowRef } from 'vue';

import { clipOf, clipText } from '#editor/clip-text';
import type { Clip } from '#editor/clipboard';

/** A part that somebody has laid onto the shelf. */
export interface OwnPart {
  readonly id: string;
  readonly name: string;
  readonly clip: Clip;
}

/** The parts that are kept in this browser. */
export interface OwnParts {
  readonly parts: Readonly<ShallowRef<readonly OwnPart[]>>;
  /** Number of stored parts that cannot be read. They stay stored. */
  readonly unread: Readonly<ShallowRef<number>>;
  /** True if the last change could not be stored: it holds as long as the page is open. */
  readonly isUnsaved: Readonly<ShallowRef<boolean>>;
  keep(name: string, clip: Clip): OwnPart;
  rename(id: string, name: string): void;
  /** Takes a part away. @returns puts it back in its place */
  remove(id: string): () => void;
  /** Reads them again: another tab may have changed them. */
  look(): void;
}

/** The storage of parts. */
export type PartStore = Pick<Storage, 'getItem' | 'setItem'>;

/** The key of the parts in the browser's storage. */
export const PARTS_KEY = 'parcours.parts';

/** An entry of the list as it is stored; `part` is `null` if it cannot be read: it is written back unchanged. */
interface Entry {
  readonly part: OwnPart | null;
  readonly raw: unknown;
}

interface Read {
  readonly entries: readonly Entry[];
  /** A text that is no list of parts. */
  readonly foreign: string | null;
}

/** The parts of a store. @param store `null`: this page keeps nothing */
export function createOwnParts(store: PartStore | null): OwnParts {
  const parts = shallowRef<readonly OwnPart[]>([]);
  const unread = shallowRef(0);
  const isUnsaved = shallowRef(false);
  let entries: readonly Entry[] = [];

  function show(now: Read): void {
    entries = now.entries;
    parts.value = entries.flatMap(({ part }) => part ?? []);
    unread.value = entries.length - parts.value.length + (now.foreign === null ? 0 : 1);
  }

  /** The stored parts; those that could not be stored are only here. */
  function look(): Read {
    const now = isUnsaved.value || store === null ? { entries, foreign: null } : read(store);
    show(now);
    return now;
  }

  function change(by: (entries: readonly Entry[]) => readonly Entry[]): void {
    const before = look();
    const changed = by(before.entries);
    show({ entries: changed, foreign: before.foreign });
    isUnsaved.value = store === null || !write(store, changed, before.foreign);
  }

  look();
  return {
    parts,
    unread,
    isUnsaved,
    look: () => void look(),
    keep(name, clip) {
      look();
      const part = { id: freeId(entries), name, clip };
      change((all) => [...all, { part, raw: rawOf(part) }]);
      return part;
    },
    rename: (id, name) =>
      change((all) => all.map((entry) => (entry.part?.id === id ? entryOf({ ...entry.part, name }) : entry))),
    remove(id) {
      look();
      const at = entries.findIndex(({ part }) => part?.id === id);
      const gone = entries[at];
      if (gone === undefined) return () => undefined;
      change((all) => all.filter((entry) => entry.part?.id !== id));
      return () => change((all) => [...all.slice(0, at), gone, ...all.slice(at)]);
    },
  };
}

const entryOf = (part: OwnPart): Entry => ({ part, raw: rawOf(part) });

/** A part as it is stored: its objects in the format of the clipboard. */
const rawOf = ({ id, name, clip }: OwnPart): unknown => ({ id, name, clip: JSON.parse(clipText(clip)) as unknown });

function read(store: PartStore): Read {
  let text: string | null = null;
  try {
    text = store.getItem(PARTS_KEY);
    if (text === null) return { entries: [], foreign: null };
    const value: unknown = JSON.parse(text);
    if (isRecord(value) && Array.isArray(value['parts']))
      return { entries: value['parts'].map((raw: unknown) => ({ part: partOf(raw), raw })), foreign: null };
  } catch {
    // no JSON, or no leave to look
  }
  return { entries: [], foreign: text };
}

function partOf(raw: unknown): OwnPart | null {
  if (!isRecord(raw) || typeof raw['id'] !== 'string' || typeof raw['name'] !== 'string') return null;
  const clip = clipOf(JSON.stringify(raw['clip'] ?? null));
  return clip && { id: raw['id'], name: raw['name'], clip };
}

const isRecord = (value: unknown): value is Readonly<Record<string, unknown>> =>
  typeof value === 'object' && value !== null;

/** Stores the list; a text that is none is put aside first, for good. */
function write(store: PartStore, entries: readonly Entry[], foreign: string | null): boolean {
  try {
    if (foreign !== null) store.setItem(freeKey(store), foreign);
    store.setItem(PARTS_KEY, JSON.stringify({ version: 1, parts: entries.map(({ raw }) => raw) }));
    return true;
  } catch {
    return false; // full, or forbidden
  }
}

function freeKey(store: PartStore): string {
  let number = 1;
  while (store.getItem(`${PARTS_KEY}.unread-${number}`) !== null) number += 1;
  return `${PARTS_KEY}.unread-${number}`;
}

function freeId(entries: readonly Entry[]): string {
  const taken = new Set(entries.map(({ raw }) => (isRecord(raw) ? raw['id'] : null)));
  let number = 1;
  while (taken.has(`own-${number}`)) number += 1;
  return `own-${number}`;
}

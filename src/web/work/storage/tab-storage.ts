/** The part of the browser's `Storage` that is used. */
export type TextStore = Pick<Storage, 'getItem' | 'setItem' | 'removeItem' | 'key' | 'length'>;

/** What a tab keeps through reloads, and what a new tab finds of it. */
export interface TabStorage {
  /** What this tab saved last; in a new tab, what any tab saved last; `null` when there is nothing. */
  load(): string | null;
  /** Saves for this tab, and as a copy that survives closing it. `false` when the browser has no room left. */
  save(text: string): boolean;
}

const TAB = 'parcours.tab';
const WORK = 'parcours.work';
const COPY = 'parcours.copy.';
const LAST = 'parcours.last';

/** Copies of closed tabs that are kept. */
const COPIES = 5;
/** Longer than this (characters) no work of a pupil is; a browser gives a page about five million. */
const HUGE = 1_000_000;

/**
 * Storage of one browser tab. `session` belongs to the tab and survives its reloads; `local` is shared by all tabs, where
 * every tab writes a copy under its own name, so that no tab overwrites another's work.
 *
 * @param newName makes a name that no other tab has
 */
export function createTabStorage(session: TextStore, local: TextStore, newName: () => string): TabStorage {
  const known = get(session, TAB);
  const name = known ?? newName();
  set(session, TAB, name);
  return {
    load: () => get(session, WORK) ?? copyOf(local, known ?? get(local, LAST)),
    save(text) {
      const kept = set(session, WORK, text);
      const copied = set(local, COPY + name, text) || makeRoom(local, name, text);
      if (copied && get(local, LAST) !== name) {
        set(local, LAST, name);
        prune(local, name, COPIES);
      }
      return kept && copied;
    },
  };
}

/** Gives a duplicated tab a name of its own: the browser copies `session` along with the tab. */
export function renameTab(session: TextStore, newName: () => string): void {
  set(session, TAB, newName());
}

/** The tab's name, or `null` before the first `createTabStorage`. */
export function tabName(session: TextStore): string | null {
  return get(session, TAB);
}

function copyOf(local: TextStore, name: string | null): string | null {
  return name === null ? null : get(local, COPY + name);
}

/** Gives up copies of other tabs, the oldest first, until `text` has room. For a huge text none is given up: it might not fit even then. */
function makeRoom(local: TextStore, name: string, text: string): boolean {
  if (text.length > HUGE) return false;
  for (let left = COPIES - 1; left >= 1; left -= 1) {
    prune(local, name, left);
    if (set(local, COPY + name, text)) return true;
  }
  return false;
}

/** Removes copies of other tabs beyond `count`; names begin with the time a tab was opened, so the oldest go first. */
function prune(local: TextStore, own: string, count: number): void {
  const copies: string[] = [];
  for (let index = 0; index < local.length; index += 1) {
    const key = local.key(index);
    if (key?.startsWith(COPY) === true && key !== COPY + own) copies.push(key);
  }
  copies.sort();
  for (const key of copies.slice(0, Math.max(0, copies.length - (count - 1)))) local.removeItem(key);
}

// A browser may forbid storage altogether (private windows, embedded pages): the app then works without.
function get(store: TextStore, key: string): string | null {
  try {
    return store.getItem(key);
  } catch {
    return null;
  }
}

function set(store: TextStore, key: string, value: string): boolean {
  try {
    store.setItem(key, value);
    return true;
  } catch {
    return false;
  }
}

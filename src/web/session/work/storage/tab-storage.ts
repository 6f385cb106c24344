/** The part of the browser's `Storage` that is used. */
export type TextStore = Pick<Storage, 'getItem' | 'setItem' | 'removeItem' | 'key' | 'length'>;

import { savedMsOf } from './history';

/** The work that a tab stores through reloads, and that a new tab finds. */
export interface TabStorage {
  /** This tab's last work; in a new tab, that of any tab; `null` if there is none. */
  load(): string | null;
  /**
   * Saves for this tab, and as a copy that survives closing it. Text longer than `SLOW` goes into the tab's own storage
   * only when the page is left. `false` when the browser has no room left.
   */
  save(text: string, isLeaving?: boolean): boolean;
  /** The tab's name, if a copy of the work goes to the disk, too. */
  readonly tab?: string;
}

const TAB = 'parcours.tab';
const WORK = 'parcours.work';
const COPY = 'parcours.copy.';
const LAST = 'parcours.last';

/** A longer text (characters) takes the tab's own storage a while: 270,000 took 5 ms, and the shared one 1 ms (Chromium). */
export const SLOW = 30_000;
/**
 * Storage of one browser tab. `session` belongs to the tab and survives its reloads; `local` is shared by all tabs, where
 * every tab writes a copy under its own name, so that no tab overwrites another's work.
 *
 * @param newName makes a name that no other tab has
 * @param from the tab whose work is opened: this one, or the one it is a duplicate of; `null`: whichever saved last
 * @param isAlone no duplicate of this tab writes under its name; else only what is in `session` is surely its own
 */
export function createTabStorage(
  session: TextStore,
  local: TextStore,
  newName: () => string,
  from = tabName(session),
  isAlone = true,
): TabStorage {
  const name = tabName(session) ?? newName();
  set(session, TAB, name);
  return {
    tab: name,
    load() {
      const own = get(session, WORK);
      return own !== null && !isAlone ? own : newer(own, copyOf(local, from ?? get(local, LAST)));
    },
    save(text, isLeaving = false) {
      const copied = set(local, COPY + name, text);
      const waits = copied && isAlone && !isLeaving && text.length > SLOW;
      const kept = waits || set(session, WORK, text);
      if (copied && get(local, LAST) !== name) set(local, LAST, name);
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

/** The copy that was saved later; the first one if neither was. */
export const newer = (one: string | null, other: string | null): string | null =>
  one === null || savedMsOf(other) > savedMsOf(one) ? other : one;

function copyOf(local: TextStore, name: string | null): string | null {
  return name === null ? null : get(local, COPY + name);
}

/** Removes the copy of a tab. */
export const dropCopy = (local: TextStore, tab: string): void => local.removeItem(COPY + tab);

function copyKeys(local: TextStore): readonly string[] {
  const keys = Array.from({ length: local.length }, (_, index) => local.key(index) ?? '');
  return keys.filter((key) => key.startsWith(COPY));
}

/** The copy of each tab, by its name. */
export const copiesOf = (local: TextStore): readonly (readonly [tab: string, text: string])[] =>
  copyKeys(local).map((key) => [key.slice(COPY.length), get(local, key) ?? '']);

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

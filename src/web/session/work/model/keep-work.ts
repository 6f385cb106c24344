import { watch } from 'vue';

import { copyOnDisk } from '../storage/disk-copy';
import { savedMsOf, stamped, workToText, type Work } from '../storage/history';
import type { DiskSaver, Kept } from '../storage/disk-saver';
import {
  createTabStorage,
  newer,
  renameTab,
  SLOW,
  tabName,
  type TabStorage,
  type TextStore,
} from '../storage/tab-storage';
import type { Unsaved } from './unsaved';
import type { WorkModel } from './work-model';

/** Longest time from a change until the work is saved, in ms, even while more changes follow. */
const SAVE_AFTER_MS = 400; // chosen: a crash costs less than a second, also if the page is busy and a copy has to be written

/** Longest wait for the copy on the disk when the page opens, in ms. Chosen: a healthy browser has it in some 10 ms. */
const PATIENCE_MS = 2000;

/** The state that a page opens with. */
export interface Opened {
  readonly storage: TabStorage;
  /** The stored work, if there is any and it can be read. */
  readonly work: Work | null;
}

/** A storage for pages that store nothing, as a host brings the work. */
const forgetful: TabStorage = { load: () => null, save: () => true };

/** The storage where the browser forbids storing: in some private windows, for some sites. */
const forbidden: TabStorage = { load: () => null, save: () => false };

/** The state of a page that stores nothing. */
export const nothingKept: Opened = { storage: forgetful, work: null };

/** This tab's storage, or one that takes nothing where the browser forbids storing. */
export async function openTabStorage(): Promise<TabStorage> {
  try {
    const [session, local]: [TextStore, TextStore] = [sessionStorage, localStorage];
    const name = tabName(session);
    if (name !== null && !(await holdsName(name))) renameTab(session, newTabName);
    // Without locks a duplicate may have the same name: then only what is in the tab's own storage is surely its own.
    const isAlone = 'locks' in navigator;
    const storage = createTabStorage(session, local, newTabName, name, isAlone);
    if (storage.tab !== undefined && storage.tab !== name) void holdsName(storage.tab);
    const late = new Promise<null>((resolve) => setTimeout(resolve, PATIENCE_MS, null));
    // A new tab opens what any tab saved last. After the browser was killed the copy on the disk is the newer one.
    const copy = isAlone || name === null ? await Promise.race([copyOnDisk(name).catch(() => null), late]) : null;
    return await withPieces({ ...storage, load: () => newer(storage.load(), copy) });
  } catch {
    return forbidden;
  }
}

const fetchLate = () => import('../storage/disk-saver');

/** The state of a page with this storage. Rejects if the part of the app that reads it cannot be loaded. */
export async function openedFrom(storage: TabStorage): Promise<Opened> {
  const text = storage.load();
  return { storage, work: text === null ? null : (await import('../storage/read-work')).workFromText(text) };
}

/** Stands in work whose large parts lie apart (`pieces.ts`). */
const APART = '"parcours.piece":';

/** The storage whose work is whole, wherever its parts lie. */
async function withPieces(storage: TabStorage): Promise<TabStorage> {
  const text = storage.load();
  if (text?.includes(APART) !== true) return storage;
  // If that part of the app cannot be loaded, the work still opens, with a bare floor.
  const late = await fetchLate().catch(() => null);
  const whole = (await late?.wholeWork(text, Date.now())) ?? text.replace(/\{"parcours\.piece":"[\w-]+"\}/g, 'null');
  return { ...storage, load: () => whole };
}

/**
 * Saves the work shortly after every change, also while it goes on changing, and at once when the page is left.
 *
 * @param onLost called with the reason when it can be saved nowhere, and with `null` once it can be again
 * @param onFirst called once, with the first copy's time in ms: from now on the copies of closed tabs can be looked for
 */
export function keepWork(
  model: WorkModel,
  storage: TabStorage,
  onLost: (why: Unsaved | null) => void,
  onFirst: (savedMs: number) => void = () => undefined,
): void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  let dueMs = 0;
  let late: DiskSaver | null = null;
  let savedMs = savedMsOf(storage.load());
  let isLost = false;
  let isBehind = false;
  function save(isLeaving = false): void {
    clearTimeout(timer);
    timer = undefined;
    if (model.unfinished.value !== null) saveSoon();
    const work = model.withUnfinished();
    // Later than the last copy even if the computer's clock was put back meanwhile.
    savedMs = Math.max(Date.now(), savedMs + 1);
    const text = stamped(late?.textOf(work) ?? workToText(work), savedMs);
    isBehind = !isLeaving && text.length > SLOW;
    void finish(work, text, storage.save(text, isLeaving));
  }
  function leave(): void {
    if (timer !== undefined || isBehind) save(true);
  }
  async function finish(work: Work, text: string, isSaved: boolean): Promise<void> {
    let kept: Kept = isSaved ? 'kept' : 'lost';
    try {
      if (storage.tab !== undefined) {
        const saver = late ?? (await fetchLate()).createDiskSaver(storage.tab);
        if (late === null) onFirst(savedMs);
        kept = await (late ??= saver).keep(work, text, isSaved);
      }
    } catch {
      // That part of the app cannot be loaded: the storage for text has to do.
    }
    if (kept === 'again') saveSoon();
    const isNow = kept === 'lost';
    if (isNow !== isLost) onLost(isNow ? (storage === forbidden ? 'forbidden' : 'full') : null);
    isLost = isNow;
  }
  function saveSoon(): void {
    if (timer !== undefined) return;
    dueMs = performance.now() + SAVE_AFTER_MS;
    timer = setTimeout(() => save(), SAVE_AFTER_MS);
  }
  function change(): void {
    // Who types very fast keeps the page so busy that browsers put its timers off.
    if (timer !== undefined && performance.now() >= dueMs) save();
    else saveSoon();
  }
  watch([model.work, model.unfinished], change);
  addEventListener('pagehide', leave);
  document.addEventListener('visibilitychange', () => {
    if (document.visibilityState === 'hidden') leave();
  });
}

/** A new name for a tab. It begins with the time, so that sorting names sorts by age. */
function newTabName(): string {
  return `${Date.now().toString(36).padStart(9, '0')}-${Math.floor(Math.random() * 1e9).toString(36)}`;
}

/**
 * Holds a lock in this tab's name as long as the page lives. A duplicated tab has the same name in its copied session
 * store, finds the lock taken and must take another name; so two tabs never write the same copy.
 *
 * @returns false if another tab holds it
 */
function holdsName(name: string): Promise<boolean> {
  // Web Locks are missing on plain http: duplicated tabs then share their copy, but their sessions still stay apart.
  const locks = (navigator as Partial<Navigator>).locks;
  if (locks === undefined) return Promise.resolve(true);
  return new Promise((resolve) => {
    locks
      .request(`parcours.tab.${name}`, { ifAvailable: true }, (lock) => {
        resolve(lock !== null);
        return lock === null ? undefined : new Promise<void>(() => {});
      })
      .catch(() => resolve(true));
  });
}

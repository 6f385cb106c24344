import { watch } from 'vue';

import { workFromText, workToText, type Work } from '../storage/history';
import type { LargeWork } from '../storage/large-work';
import { createTabStorage, renameTab, tabName, type TabStorage, type TextStore } from '../storage/tab-storage';
import type { WorkModel } from './work-model';

/** How long after the last keystroke the work is saved, in ms. */
const SAVE_AFTER_MS = 300; // chosen: a crash costs at most a word

/** A storage for pages that keep nothing: where the browser forbids it, or a host brings the work. */
export const forgetful: TabStorage = { load: () => null, save: () => true };

/** This tab's storage, or one that forgets where the browser forbids storing. */
export async function openTabStorage(): Promise<TabStorage> {
  try {
    const [session, local]: [TextStore, TextStore] = [sessionStorage, localStorage];
    const name = tabName(session);
    if (name !== null && !(await holdsName(name))) renameTab(session, newTabName);
    const storage = createTabStorage(session, local, newTabName);
    const own = tabName(session);
    if (own !== null && own !== name) void holdsName(own);
    return await withPieces(storage);
  } catch {
    return forgetful;
  }
}

/** The stored work, if there is any and it can be read. */
export function storedWork(storage: TabStorage): Work | null {
  const text = storage.load();
  return text === null ? null : workFromText(text);
}

/** What is longer (characters) than any program and its course has a picture as floor: its large parts are stored apart. */
const LARGE = 100_000;
/** Stands in work whose large parts lie apart (`pieces.ts`). */
const APART = '"parcours.piece":';

/** The storage whose work is whole, wherever its parts lie. */
async function withPieces(storage: TabStorage): Promise<TabStorage> {
  const text = storage.load();
  if (text?.includes(APART) !== true) return storage;
  // Where that part of the app does not come, the work opens all the same, with a bare floor.
  const late = await import('../storage/large-work').catch(() => null);
  const whole = (await late?.wholeWork(text, Date.now())) ?? text.replace(/\{"parcours\.piece":"[\w-]+"\}/g, 'null');
  return { load: () => whole, save: (changed) => storage.save(changed) };
}

/** Saves the work shortly after every change, and at once when the page is left. */
export function keepWork(model: WorkModel, storage: TabStorage, onFull: () => void): void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  let large: LargeWork | null = null;
  function save(): void {
    if (timer === undefined) return;
    clearTimeout(timer);
    timer = undefined;
    const work = model.work.value;
    const text = large?.textOf(work) ?? workToText(work);
    const isSaved = storage.save(text);
    if (text.length < LARGE && isSaved) return;
    // Until its large parts are apart they stay with the work, so that a crash meanwhile costs nothing.
    void setApart(work).then((isSmaller) => {
      if (isSmaller) saveSoon();
      else if (!isSaved) onFull();
    });
  }
  /** Stores the large parts of the work elsewhere. Returns whether there were any that were not there yet. */
  async function setApart(work: Work): Promise<boolean> {
    try {
      const { LargeWork } = await import('../storage/large-work');
      large ??= new LargeWork();
      return await large.setApart(work, Date.now());
    } catch {
      return false;
    }
  }
  function saveSoon(): void {
    clearTimeout(timer);
    timer = setTimeout(save, SAVE_AFTER_MS);
  }
  watch(model.work, saveSoon);
  addEventListener('pagehide', save);
  document.addEventListener('visibilitychange', () => {
    if (document.visibilityState === 'hidden') save();
  });
}

/** Begins with the time, so that sorting names sorts by age. */
function newTabName(): string {
  return `${Date.now().toString(36).padStart(9, '0')}-${Math.floor(Math.random() * 1e9).toString(36)}`;
}

/**
 * Holds a lock in this tab's name as long as the page lives. A duplicated tab has the same name in its copied session
 * store, finds the lock taken and must take another name; so two tabs never write the same copy.
 */
function holdsName(name: string): Promise<boolean> {
  // Web Locks are missing on plain http: duplicated tabs then share their copy, their sessions stay apart all the same.
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

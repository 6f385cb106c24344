import { pageStorage } from '../../../session/work/storage/memory-storage';
import { WAYS, type Way } from './ways';

const KEY = 'parcours.way-to-board';

/** The way that worked last in this browser. */
export function lastWay(storage = pageStorage()): Way | null {
  const kept = storage.getItem(KEY);
  return WAYS.find((way) => way === kept) ?? null;
}

/** Remembers the way that has just worked. */
export function rememberWay(way: Way, storage = pageStorage()): void {
  try {
    storage.setItem(KEY, way);
  } catch {
    // Full or forbidden: the next visit begins as the first.
  }
}

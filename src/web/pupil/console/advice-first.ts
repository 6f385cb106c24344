import type { ConsoleEntry } from './log/console-log';

/** The same entries with every error's explanation before the traceback it explains. */
export function adviceFirst(entries: readonly ConsoleEntry[]): readonly ConsoleEntry[] {
  const arranged: ConsoleEntry[] = [];
  for (const entry of entries) {
    let place = arranged.length;
    if (entry.kind === 'error') while (isTraceback(arranged[place - 1])) place -= 1;
    arranged.splice(place, 0, entry);
  }
  return arranged;
}

const isTraceback = (entry: ConsoleEntry | undefined): boolean => entry?.kind === 'text' && entry.tone === 'error';

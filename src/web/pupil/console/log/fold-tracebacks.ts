import type { ConsoleEntry } from './console-log';

/** A piece of what a program has printed. */
export type TextEntry = Extract<ConsoleEntry, { kind: 'text' }>;

/** An entry as it is shown; a card has the traceback that it explains. */
export interface ShownEntry {
  readonly entry: ConsoleEntry;
  readonly traceback: readonly TextEntry[];
}

/** The same entries, every traceback within the card of its error. */
export function foldTracebacks(entries: readonly ConsoleEntry[]): readonly ShownEntry[] {
  const shown: ShownEntry[] = [];
  for (const entry of entries) {
    const traceback: TextEntry[] = [];
    if (entry.kind === 'error')
      for (let last = shown.at(-1)?.entry; isTraceback(last); last = shown.at(-1)?.entry) {
        traceback.unshift(last);
        shown.pop();
      }
    shown.push({ entry, traceback });
  }
  return shown;
}

const isTraceback = (entry: ConsoleEntry | undefined): entry is TextEntry =>
  entry?.kind === 'text' && entry.tone === 'error';

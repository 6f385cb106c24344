import type { ConsoleEntry } from './console-log';

/** Most lines that are read aloud at once. Chosen: half a minute of listening. */
const LINES = 12;

/** The last line that the program of the present run has printed; `''`: none. */
export const latestLine = (entries: readonly ConsoleEntry[]): string => latestLines(entries).split('\n').at(-1) ?? '';

/** The last lines that the program of the present run has printed, without tracebacks; `''`: none. */
export function latestLines(entries: readonly ConsoleEntry[]): string {
  const start = entries.findLastIndex(({ kind }) => kind === 'run');
  const text = entries
    .slice(start + 1)
    .map((entry) => (entry.kind === 'text' && entry.tone === 'plain' ? entry.text : ''))
    .join('');
  return text.trim().split('\n').slice(-LINES).join('\n');
}

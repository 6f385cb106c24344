import type { ConsoleEntry } from './console-log';

/** How the REPL greets (micropython, shared/runtime/pyexec.c), up to its first prompt. */
const GREETING = /^MicroPython v[^\n]*\nType "help\(\)" for more information\.\n(?:>>> )?/;

/**
 * The entries that the console shows: without the greeting with which the REPL follows each program, until somebody
 * goes to the REPL of that run. Only the picture is shorter: the log keeps all that the device sent.
 *
 * @param visited numbers of the runs at whose REPL somebody was
 * @param current number of the last run: entries whose heading is gone are its
 */
export function foldGreetings(
  entries: readonly ConsoleEntry[],
  visited: ReadonlySet<number>,
  current: number,
): readonly ConsoleEntry[] {
  const shown: ConsoleEntry[] = [];
  let run = current;
  let isOver = false;
  for (const entry of entries) {
    if (entry.kind === 'run') {
      run = entry.number;
      isOver = false;
    } else if (entry.kind === 'text' ? entry.tone !== 'plain' : entry.kind !== 'fit') isOver = true; // a traceback, a note or a card tells how the program ended
    const text = entry.kind === 'text' && isOver && !visited.has(run) ? entry.text.replace(GREETING, '') : null;
    if (text === null || entry.kind !== 'text' || text === entry.text) shown.push(entry);
    else if (text !== '') shown.push({ ...entry, text });
  }
  return shown;
}

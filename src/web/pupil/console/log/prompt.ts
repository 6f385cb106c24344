import type { ConsoleEntry } from './console-log';

/**
 * MicroPython's prompts (shared/runtime/pyexec.c) that a field for lines shows: the next line of a block, or a new one.
 */
export type Prompt = '>>>' | '...';

/** The prompt at which the REPL waits, by the last line it wrote. */
export function promptOf(entries: readonly ConsoleEntry[]): Prompt {
  const last = entries.findLast((entry) => entry.kind === 'text');
  const line = last?.kind === 'text' ? last.text.slice(last.text.lastIndexOf('\n') + 1) : '';
  return line.startsWith('... ') ? '...' : '>>>';
}

import type { ReferenceContext } from '#reference/context';
import { describe } from '#reference/describe';

import { wordsOn, type Words } from '../help/words-on';
import { codeShown, type PaletteCommand } from './commands';

/** Offset of the name that explains a command, in a program of nothing but the command, below its imports. */
function offsetOf({ code, said }: PaletteCommand, imports: string): number {
  const last = said?.lastIndexOf('.') ?? 0;
  return imports.length + codeShown(code).indexOf(said ?? '') + last + 1;
}

/**
 * The reference's text on a command, up to its first full stop, colon or semicolon; empty if there is none.
 *
 * @param imports the lines that bring the names of the command
 */
export function aboutIn(
  command: PaletteCommand,
  imports: readonly string[],
  context: ReferenceContext,
  words: Words,
): string {
  if (command.said === null) return '';
  const above = imports.map((line) => `${line}\n`).join('');
  const found = describe(above + codeShown(command.code).replaceAll('…', 'pass'), offsetOf(command, above), context);
  const text = found === null ? '' : wordsOn(found.item, words);
  return /^.*?[.:;](?=\s|$)/.exec(text)?.[0].replace(/[:;]$/, '.') ?? text;
}

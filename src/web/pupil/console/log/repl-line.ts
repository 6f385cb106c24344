const RUBOUT = '\x7f';
const INDENT = '    ';
/** More levels than anyone types by hand; on an empty line a rubout does nothing. */
const DEEPEST = 8;

/**
 * A whole line for the REPL. The device indents the lines of a block by itself (micropython, shared/readline), which a
 * field for whole lines cannot show: its spaces are rubbed out first, one rubout for a level, and what was typed holds.
 * A line of spaces alone ends the block.
 */
export function replLine(line: string): string {
  return `${RUBOUT.repeat(DEEPEST)}${line.trim() === '' ? '' : line}\r`;
}

/** The spaces with which the line after this one begins: one level more after a colon, else the same as before. */
export function nextIndent(line: string): string {
  if (line.trim() === '') return '';
  const own = /^ */.exec(line)?.[0] ?? '';
  return /:\s*(#.*)?$/.test(line) ? own + INDENT : own;
}

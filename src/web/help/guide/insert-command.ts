import type { Command } from './commands';

/** The change of a program, and the cursor after it: offsets in the text before and after. */
export interface Insertion {
  readonly changes: readonly { readonly from: number; readonly to: number; readonly insert: string }[];
  readonly select: { readonly anchor: number; readonly head: number };
}

/**
 * Puts a command into a program at the cursor. An empty line takes it; behind other code it gets a line of its own, one
 * step further in after a colon; what is marked is replaced. The module is imported where it is not. The first argument
 * is marked afterwards: what is typed replaces it.
 *
 * @param from where the marked text begins, or the cursor
 */
export function insertionOf(program: string, from: number, to: number, command: Command): Insertion {
  const { prefix, isMissing } = importOf(program, command.module);
  const code = prefix + command.code;
  if (!isMissing) {
    const lead = leadOf(program, from, to);
    return { changes: [{ from, to, insert: lead + code }], select: selectionIn(code, from + lead.length) };
  }
  const place = placeOfImport(program);
  const line = `from ${command.module} import *`;
  // The import comes first, even where the cursor stands above its place.
  if (from < place) {
    const before = endsLine(program, place) ? `${line}\n` : `\n${line}\n`;
    const insert = `${before}${code}${place === program.length ? '' : '\n'}`;
    return { changes: [{ from: place, to: place, insert }], select: selectionIn(code, place + before.length) };
  }
  const lead = leadOf(program, from, to);
  const own = endsLine(program, place) ? `${line}\n` : `\n${line}`;
  const at = from + own.length + lead.length;
  const changes =
    place === from
      ? [{ from, to, insert: own + lead + code }]
      : [
          { from: place, to: place, insert: own },
          { from, to, insert: lead + code },
        ];
  return { changes, select: selectionIn(code, at) };
}

/** True if a line begins here. */
const endsLine = (program: string, place: number): boolean => place === 0 || program[place - 1] === '\n';

/** The first argument of what was written at a place, or the end of it. */
function selectionIn(code: string, at: number): Insertion['select'] {
  const open = code.indexOf('(') + 1;
  const [argument = ''] = code.slice(open, -1).split(',');
  const anchor = argument === '' ? at + code.length : at + open;
  return { anchor, head: anchor + argument.length };
}

/** The prefix of the module's names in this program, and whether its import is missing. */
function importOf(program: string, module: string): { readonly prefix: string; readonly isMissing: boolean } {
  const has = (pattern: string): boolean => new RegExp(`^[ \\t]*${pattern}`, 'm').test(program);
  if (has(`from[ \\t]+${module}[ \\t]+import[ \\t]*\\*`)) return { prefix: '', isMissing: false };
  const as = new RegExp(`^[ \\t]*import[ \\t]+${module}[ \\t]+as[ \\t]+(\\w+)`, 'm').exec(program)?.[1];
  if (as !== undefined) return { prefix: `${as}.`, isMissing: false };
  if (has(`import[ \\t]+${module}[ \\t]*(#.*)?$`)) return { prefix: `${module}.`, isMissing: false };
  return { prefix: '', isMissing: true };
}

/** The place after the imports and comments with which the program begins. */
function placeOfImport(program: string): number {
  let [at, place] = [0, 0];
  for (const line of program.split('\n')) {
    const isImport = /^(from|import)\b/.test(line);
    if (!isImport && !/^\s*(#.*)?$/.test(line)) break;
    at += line.length + 1;
    if (isImport || line.startsWith('#')) place = at;
  }
  return Math.min(place, program.length);
}

/** The text before the command: a new line with its indentation if the cursor's line already has code. */
function leadOf(program: string, from: number, to: number): string {
  if (from !== to) return '';
  const start = program.lastIndexOf('\n', from - 1) + 1;
  const before = program.slice(start, from);
  const end = program.indexOf('\n', from);
  const behind = program.slice(from, end < 0 ? program.length : end);
  // In the middle of a line it is a part of it: print( … ).
  const goesOn = /[(=,+\-*/<>]\s*$/.test(before) && !before.trim().endsWith('import *');
  if (before.trim() === '' || behind.trim() !== '' || goesOn) return '';
  const indent = /^[ \t]*/.exec(before)?.[0] ?? '';
  return `\n${indent}${/:\s*(#.*)?$/.test(before) ? '    ' : ''}`;
}

import { readUpTo } from './reading';

/** Names for counting, in the order in which loops within loops get them. */
const COUNTERS = ['i', 'j', 'k', 'm', 'n', 'p', 'q', 'r'];

const REPEAT = /^(\s*)repeat\b\s*(.*?)\s*(:.*)?$/;

/** A program without TigerJython's loops, and what one of its lines has become. */
export interface Unrepeated {
  readonly text: string;
  readonly code: string;
}

/** A line of a program that was written otherwise. */
export interface RewrittenLine {
  /** Counted from 1. */
  readonly line: number;
  /** Without the line break, as the text after. */
  readonly before: string;
  readonly after: string;
}

/** Python's line for a loop that runs `count` times (empty: for ever), up to its colon. */
const headOf = (indent: string, count: string, name: string): string =>
  count === '' ? `${indent}while True` : `${indent}for ${name} in range(${/^\(([^()]*)\)$/.exec(count)?.[1] ?? count})`;

/**
 * Writes every `repeat n:` as `for i in range(n):` and every `repeat:` as `while True:`. Loops within loops count with
 * other names, and none with a name that the program has. `null` where a line is not surely such a loop.
 *
 * @param codes the lines without texts and comments
 * @param asked the line, counted from 1, whose new look is given
 */
export function withoutRepeat(lines: readonly string[], codes: readonly string[], asked: number): Unrepeated | null {
  if (codes.some((code) => /^\s*(?:def|class)\s+repeat\b|\brepeat\s*=/.test(code))) return null;
  const free = COUNTERS.filter((name) => !codes.some((code) => new RegExp(`\\b${name}\\b`).test(code)));
  const around: number[] = [];
  const mended = lines.map((line, index) => {
    const code = codes[index] ?? '';
    const indent = code.length - code.trimStart().length;
    if (code.trim() === '') return line;
    while (around.length > 0 && (around.at(-1) ?? 0) >= indent) around.pop();
    const loop = loopOf(line, code, free[around.length]);
    if (loop === null) return line;
    around.push(indent);
    return loop;
  });
  const code = mended[asked - 1];
  if (code === undefined || code === lines[asked - 1]) return null;
  return { text: mended.join('\n'), code: /^\s*((?:for|while)\b[^:]*:)/.exec(code)?.[1] ?? code.trim() };
}

function loopOf(line: string, code: string, name: string | undefined): string | null {
  const found = REPEAT.exec(code);
  if (found === null || /["']/.test(line) || /^\s*repeat\s*[=.,]|^\s*repeat\s*\([^()]*\)\s*$/.test(code)) return null;
  const [, indent = '', count = '', colon] = found;
  if (colon === undefined && (count === '' || line.includes('#'))) return null;
  const tail = colon === undefined ? ':' : line.slice(code.indexOf(colon));
  if (count !== '' && (name === undefined || !/^[\w.+\-*/() ]+$/.test(count))) return null;
  return headOf(indent, count, name ?? '') + tail;
}

/**
 * A program that was written for TigerJython or WebTigerPython, in Python: every line `repeat n:` becomes
 * `for _ in range(n):`, every `repeat:` becomes `while True:`. Only a line that begins with `repeat` and ends in `:` is such
 * a loop, perhaps with a comment behind; a string, a bracket, a block on the same line is left as it is. Line numbers,
 * indentation and comments stay. Loops within loops may share `_`, because nothing reads it; where the program has
 * that name itself they get another.
 */
export function rewriteRepeat(text: string): { readonly text: string; readonly lines: readonly RewrittenLine[] } {
  if (!/^[ \t]*repeat\b/m.test(text)) return { text, lines: [] };
  const lines = text.split('\n');
  const { codes, ends, depths, open } = readUpTo(lines, lines.length);
  const name = unusedName(codes);
  const rewritten: RewrittenLine[] = [];
  for (const [index, before] of lines.entries()) {
    const isWhole = depths[index] === 0 && (depths[index + 1] ?? open.length) === 0;
    const code = (codes[index] ?? '').trimEnd();
    if (!isWhole || !isLoop(code) || endsOpen(lines, ends, index - 1)) continue;
    const written = before.slice(0, ends[index]).trimEnd();
    const [, indent = '', count = ''] = /^(\s*)repeat\s*(.*?)\s*:$/.exec(written) ?? [];
    const after = headOf(indent, count, name) + before.slice(written.length - 1);
    lines[index] = after;
    rewritten.push({ line: index + 1, before: withoutReturn(before), after: withoutReturn(after) });
  }
  return { text: lines.join('\n'), lines: rewritten };
}

/** `_`, or the first of `_1`, `_2`, … that no line of the program has. */
function unusedName(codes: readonly string[]): string {
  const used = new Set(codes.flatMap((code) => code.match(/\b_\d*\b/g) ?? []));
  let name = '_';
  for (let number = 1; used.has(name); number += 1) name = `_${String(number)}`;
  return name;
}

/** True if a line of code is the head of such a loop: `repeat`, nothing or one value, and one colon, which ends it. */
function isLoop(code: string): boolean {
  if (!/^\s*repeat\b(?!\s*[=.,;\]})]).*:$/.test(code)) return false;
  let depth = 0;
  for (const sign of code.slice(0, -1)) {
    if ('([{'.includes(sign)) depth += 1;
    else if (')]}'.includes(sign)) depth -= 1;
    else if (depth === 0 && /[:,;]/.test(sign)) return false;
  }
  return true;
}

/** True if a line goes on in the next one, by a backslash at its end. */
function endsOpen(lines: readonly string[], ends: readonly number[], index: number): boolean {
  const line = withoutReturn(lines[index] ?? '');
  return (ends[index] ?? 0) >= line.length && line.endsWith('\\');
}

const withoutReturn = (line: string): string => (line.endsWith('\r') ? line.slice(0, -1) : line);

import { parentsOf, readPython, textOf, type PythonText, type SyntaxNode } from '#python/tree';

/** A number in a program, with the minus that belongs to it. */
export interface NumberAt {
  /** Its place in the text, from the minus on. */
  readonly from: number;
  readonly to: number;
  /** As it is written. */
  readonly text: string;
  /** Line in which its digits are, from 1. */
  readonly line: number;
  /** True: what stands around it binds tighter than a minus, as in `4**2`. */
  readonly isTight: boolean;
}

/** Parts of a program whose digits are no numbers. */
const TEXTS: ReadonlySet<string> = new Set(['String', 'ContinuedString', 'FormatString', 'Comment']);

/**
 * The numbers of a program, in the order of the text. A minus belongs to a number only where an operand begins: in
 * `base-400` the number is 400.
 */
export function numbersIn(text: string): readonly NumberAt[] {
  const source = readPython(text);
  const found: NumberAt[] = [];
  const lines = lineCounter(text);
  source.tree.iterate({
    enter: ({ name, node }) => {
      if (TEXTS.has(name)) return false;
      if (name === 'Number') found.push(numberAt(source, node, lines(node.from)));
      return true;
    },
  });
  return found;
}

/** The numbers of one line, from the left. */
export const numbersOfLine = (text: string, line: number): readonly NumberAt[] =>
  numbersIn(text).filter((one) => one.line === line);

/** Number of lines of a text. */
export const lineCount = (text: string): number => linesOf(text).length;

/** A line of a text, from 1, without the spaces around it. */
export const lineOf = (text: string, line: number): string => (linesOf(text)[line - 1] ?? '').trim();

const linesOf = (text: string): readonly string[] => text.split(/\r\n|\r|\n/);

/** The same program with another number in a place. */
export function withNumber(text: string, { from, to, isTight }: NumberAt, value: number): string {
  const plain = String(value);
  const written = value < 0 && isTight ? `(${plain})` : plain;
  // `return-4` has no space that would part another number from the word.
  const gap = /^[\d.]/.test(written) && /[\p{L}\p{N}_]$/u.test(text.slice(0, from)) ? ' ' : '';
  return text.slice(0, from) + gap + written + text.slice(to);
}

/** Says in which line a place is; asked with places in their order. */
function lineCounter(text: string): (place: number) => number {
  const ends = Array.from(text.matchAll(/\r\n|\r|\n/g), (end) => end.index);
  let line = 0;
  return (place) => {
    while ((ends[line] ?? Infinity) < place) line += 1;
    return line + 1;
  };
}

function numberAt(source: PythonText, node: SyntaxNode, line: number): NumberAt {
  const minus = minusBefore(source, node);
  const from = minus?.from ?? node.from;
  const to = node.to + (isPointBehind(source, node) ? 1 : 0);
  return { from, to, text: source.text.slice(from, to), line, isTight: isTight(source, node) };
}

/** The minus of an operand that is this number alone; `null`: there is none in its line. */
function minusBefore(source: PythonText, node: SyntaxNode): SyntaxNode | null {
  const sign = node.prevSibling;
  const isOperand = ['UnaryExpression', 'LiteralPattern'].includes(node.parent?.name ?? '');
  if (sign === null || !isOperand || textOf(source, sign) !== '-') return null;
  return /[\r\n]/.test(source.text.slice(sign.from, node.from)) ? null : sign;
}

/** True for `5.`, which the parser takes for the beginning of a name of the number. */
function isPointBehind({ text }: PythonText, { parent, nextSibling, to }: SyntaxNode): boolean {
  const isMember = parent?.name === 'MemberExpression' && nextSibling?.name === '.' && nextSibling.from === to;
  return isMember && !/[\p{L}_]/u.test(text[to + 1] ?? '');
}

function isTight(source: PythonText, node: SyntaxNode): boolean {
  const [parent] = parentsOf(node);
  const next = node.nextSibling;
  if (next === null || parent === undefined) return false;
  return parent.name === 'MemberExpression' || (parent.name === 'BinaryExpression' && textOf(source, next) === '**');
}

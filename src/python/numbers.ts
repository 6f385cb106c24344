import { readPython, textOf, type PythonText, type SyntaxNode } from './tree';

/** A number in a program, with the minus that belongs to it. */
export interface NumberAt {
  /** Its place in the text, from the minus on. */
  readonly from: number;
  readonly to: number;
  /** As it is written. */
  readonly text: string;
  /** `NaN`: an imaginary one. */
  readonly value: number;
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
      // The digits behind `5.e-` are a part of that number.
      if (name === 'Number' && node.from >= (found.at(-1)?.to ?? 0))
        found.push(numberAt(source, node, lines(node.from)));
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
export const withNumber = (text: string, at: NumberAt, value: number): string =>
  text.slice(0, at.from) + writtenNumber(text, at, value) + text.slice(at.to);

/** Another number as it is written in a place of a program, with brackets or a space where it needs them. */
export function writtenNumber(text: string, { from, isTight }: NumberAt, value: number): string {
  const plain = String(value);
  const written = value < 0 && isTight ? `(${plain})` : plain;
  // `return-4` has no space that would part another number from the word.
  const gap = /^[\d.]/.test(written) && /[\p{L}\p{N}_]$/u.test(text.slice(0, from)) ? ' ' : '';
  return gap + written;
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
  const behind = pointBehind(source, node);
  const operand = behind === '' ? node : (node.parent ?? node);
  const minus = minusBefore(source, operand, node);
  const from = minus?.from ?? node.from;
  const to = node.to + behind.length;
  const size = Number(source.text.slice(node.from, to).replaceAll('_', ''));
  return {
    ...{ from, to, line, text: source.text.slice(from, to) },
    value: minus === null ? size : -size,
    isTight: isTight(source, operand),
  };
}

/** The minus of an operand that is this number alone; `null`: there is none in its line. */
function minusBefore(source: PythonText, operand: SyntaxNode, { from }: SyntaxNode): SyntaxNode | null {
  const sign = operand.prevSibling;
  const isOperand = ['UnaryExpression', 'LiteralPattern'].includes(operand.parent?.name ?? '');
  if (sign === null || !isOperand || textOf(source, sign) !== '-') return null;
  return /[\r\n]/.test(source.text.slice(sign.from, from)) ? null : sign;
}

/** The end of `5.` or `5.e-3`, which the parser takes for the beginning of a name of the number 5. */
function pointBehind({ text }: PythonText, { parent, nextSibling, to }: SyntaxNode): string {
  const isMember = parent?.name === 'MemberExpression' && nextSibling?.name === '.' && nextSibling.from === to;
  return (isMember && /^\.(?:e[+-]?\d[\d_]*)?(?![\p{L}\p{N}_])/iu.exec(text.slice(to))?.[0]) || '';
}

function isTight(source: PythonText, operand: SyntaxNode): boolean {
  const { parent, nextSibling: next } = operand;
  if (next === null || parent === null) return false;
  return parent.name === 'MemberExpression' || (parent.name === 'BinaryExpression' && textOf(source, next) === '**');
}

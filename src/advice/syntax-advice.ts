import type { AdviceKey, AdviceValues } from './text';
import { CLOSING, OPENING, readUpTo, type Reading } from './reading';
import { withoutRepeat } from './repeat';
import { lacksComma, slipIn, type Slip } from './slips';

/** A line of a pupil's file. */
export interface Source {
  readonly text: string;
  /** Counted from 1. */
  readonly line: number;
}

/** Explanation of a line that MicroPython rejects with "invalid syntax", as far as its cause can be found. */
export interface SyntaxAdvice {
  readonly key: AdviceKey;
  readonly values: AdviceValues;
  readonly mend?: Mend;
}

/** A change that corrects a file. */
export interface Mend {
  /** The whole file before and after the change. */
  readonly before: string;
  readonly after: string;
  /** The rewritten code, as shown on the button. */
  readonly code: string;
  /** A line more, not one written otherwise. */
  readonly adds?: true;
}

const BLOCK = /^(if|elif|else|for|while|def|class|try|except|finally|with)\b/;
const CONTINUES = /^(elif|else|except|finally)\b/;
const KEYWORDS =
  /^(and|as|assert|break|class|continue|def|del|elif|else|except|finally|for|from|global|if|import|in|is|lambda|not|or|pass|raise|return|try|while|with|yield)$/;

const say = (key: AdviceKey, values: AdviceValues = {}): SyntaxAdvice => ({ key, values });

/**
 * Looks for the usual mistakes around a line: a missing colon, bracket, quotation mark or indentation, `=` for `==`.
 * MicroPython itself says "invalid syntax" for all of them. In doubt it finds nothing.
 */
export function syntaxAdvice({ text, line }: Source): SyntaxAdvice | null {
  const lines = text.split(/\r\n?|\n/);
  const read = readUpTo(lines, line);
  const above = { text, line: read.codes.slice(0, line - 1).findLastIndex((it) => it.trim() !== '') + 1 };
  // Below an open bracket every line looks wrong, so it is reported first, wherever the device stopped.
  const isWithin = read.open.some((it) => it.line < line);
  if (isWithin) return atLine(lines, read, { text, line });
  const before = above.line === 0 ? null : above;
  return (
    (before && endAbove(lines, read.codes, before)) ??
    atLine(lines, read, { text, line }) ??
    aroundLine(read.codes, line) ??
    (before && atLine(lines, readUpTo(lines, before.line), before))
  );
}

/** Explains an error within one line, ignoring the lines before it. */
function atLine(lines: readonly string[], read: Reading, { text, line }: Source): SyntaxAdvice | null {
  const code = read.codes[line - 1] ?? '';
  const written = lines[line - 1] ?? '';
  const mended = (slip: Slip | null): SyntaxAdvice | null => slip && withMend(slip, text, line);
  const isWithin = read.open.some((it) => it.line < line);
  if (!isWithin) {
    const begun = /^\s*(?:\/\/|\/\*)/.test(written) ? mended(slipIn(written.trim(), written)) : null;
    if (begun !== null) return begun;
    const loop = /^\s*repeat\b\s*(?![\s=.,])/.test(code) ? repeatAdvice(text, lines, line) : null;
    if (loop !== null) return loop;
  }
  if (read.openText !== null && readUpTo(lines, lines.length).openText === read.openText)
    return say('error.openLongText', { line: read.openText });
  const quotes = quoteAdvice(read, code, { text, line });
  if (quotes !== null) return quotes;
  if (read.extra !== null) return say('error.extraBracket', { bracket: read.extra });
  if (read.mixed !== null) return say('error.mixedBrackets', { ...read.mixed });
  const slip = isWithin ? null : mended(slipIn(code.trim(), written));
  if (slip !== null) return slip;
  const [open] = read.open;
  if (open !== undefined) return openAdvice(lines, line);
  return inLine(code.trim(), { text, line });
}

/** The advice of a slip, with the file in which its line is written right. */
export function withMend({ key, values, line: right }: Slip, text: string, line: number): SyntaxAdvice {
  if (right === undefined || text.includes('\r')) return { key, values };
  const lines = text.split('\n');
  lines[line - 1] = right;
  return { key, values, mend: { before: text, after: lines.join('\n'), code: right.trim() } };
}

/** The first TigerJython loop in a program that has not run yet: its line, counted from 1, and the correction. */
export function repeatIn(text: string): { readonly line: number; readonly advice: SyntaxAdvice } | null {
  const lines = text.split('\n');
  const { codes } = readUpTo(lines, lines.length);
  const line = codes.findIndex((code) => /^\s*repeat\b[^=]*:/.test(code)) + 1;
  const advice = line === 0 ? null : repeatAdvice(text, lines, line);
  return advice && { line, advice };
}

/** TigerJython's loop. The sentence names the equivalent line; the button rewrites all such loops. */
function repeatAdvice(text: string, lines: readonly string[], line: number): SyntaxAdvice | null {
  const found = text.includes('\r') ? null : withoutRepeat(lines, readUpTo(lines, lines.length).codes, line);
  if (found === null) return null;
  const { text: after, code } = found;
  return { ...say('error.repeat', { code }), mend: { before: text, after, code } };
}

const CURLY = /[“”„‘’«»‹›´`]/;

/** Texts that do not end, and quotation marks of a word processor. */
function quoteAdvice({ openQuote }: Reading, code: string, { text, line }: Source): SyntaxAdvice | null {
  const written = text.split('\n')[line - 1] ?? '';
  if (openQuote === null) return CURLY.test(code) ? curlyAdvice({ text, line }) : null;
  const marks = written.match(new RegExp(CURLY, 'g')) ?? [];
  if (marks.length !== 1) return say('error.openQuote', { line: openQuote });
  const right = written.replace(CURLY, written.includes('"') ? '"' : "'");
  return withMend({ key: 'error.curlyQuotes', values: {}, line: right }, text, line);
}

/** Quotation marks of a word processor around a string; if the line has other ones too, nothing is rewritten. */
export function curlyAdvice({ text, line }: Source): SyntaxAdvice {
  const written = text.split('\n')[line - 1] ?? '';
  const right = written.replace(/[“”„«»]/g, '"').replace(/[‘’‹›´`]/g, "'");
  const isSure = !/["'#]/.test(written) && (right.match(/["']/g) ?? []).length % 2 === 0;
  return withMend({ key: 'error.curlyQuotes', values: {}, ...(isSure ? { line: right } : {}) }, text, line);
}

/** A bracket that is open where the device stopped: at the end of the file too, or only there. */
function openAdvice(lines: readonly string[], line: number): SyntaxAdvice {
  const atEnd = readUpTo(lines, lines.length).open[0];
  return atEnd !== undefined && atEnd.line <= line ? say('error.openBracket', { ...atEnd }) : say('error.missingComma');
}

/** Mistakes that show in the line itself; texts in it are empty. */
function inLine(code: string, { text, line }: Source): SyntaxAdvice | null {
  const named = (/^(\w+)\s*=(?!=)/.exec(code) ?? /^(?:def|class|for)\s+(\w+)/.exec(code))?.[1] ?? '';
  if (KEYWORDS.test(named)) return say('error.keywordAsName', { name: named });
  const block = BLOCK.exec(code)?.[1];
  const outside = outsideBrackets(code);
  if (block !== undefined && /^(if|elif|while)$/.test(block) && /[^=!<>:+\-*/%&|^]=(?!=)/.test(outside))
    return say('error.equalsInCondition');
  if (block !== undefined && !outside.includes(':')) return colonAdvice(block, text, line);
  if (lacksComma(code)) return say('error.missingComma');
  const sign = /\+\+|--$|&&|\|\||=>|=<|=\s+=|!(?!=)/.exec(code)?.[0];
  return sign === undefined ? null : say('error.strangeSign', { sign });
}

/** The colon is written at the end where the block follows below, and nothing else is in the line. */
function colonAdvice(word: string, text: string, line: number): SyntaxAdvice {
  const lines = text.split('\n');
  const [written = '', below = ''] = lines.slice(line - 1);
  const isSure = !written.includes('#') && indentOf(below) > indentOf(written);
  const right = written.replace(/\s*;?\s*$/, ':');
  return withMend({ key: 'error.missingColon', values: { word }, ...(isSure ? { line: right } : {}) }, text, line);
}

/** Ends that a line of code cannot have. */
const UNFINISHED =
  /(?:[-+*/%<>=&|^~@]|[^\d.\s]\s*\.|\b(?:and|or|not|in|is|import|from|as|del|assert|lambda|global|nonlocal))$/;

/**
 * Something is missing at the end of the last line of code before. MicroPython 1.18 reports it for the next line with
 * code. (No MicroPython gets past such a line.)
 */
function endAbove(lines: readonly string[], codes: readonly string[], { text, line }: Source): SyntaxAdvice | null {
  const code = (codes[line - 1] ?? '').trim();
  if ([codes[line - 2], code].some((it) => it?.trimEnd().endsWith('\\') === true)) return null;
  const word = BLOCK.exec(code)?.[1];
  if (word !== undefined && !outsideBrackets(code).includes(':')) {
    const { values, mend } = colonAdvice(word, text, line);
    return { ...say('error.missingColonAbove', { ...values, line }), ...(mend && { mend }) };
  }
  if (!UNFINISHED.test(code) || /\bimport\s*\*$/.test(code)) return null;
  const advice = atLine(lines, readUpTo(lines, line), { text, line });
  return advice === null || advice.key === 'error.valueMissing' ? say('error.unfinishedAbove', { line }) : advice;
}

/** Mistakes that show by the lines before: a block that is not indented, `else` without its `if`. */
function aroundLine(codes: readonly string[], line: number): SyntaxAdvice | null {
  const code = codes[line - 1] ?? '';
  const before = codes.slice(0, line - 1).findLast((it) => it.trim() !== '');
  if (before?.trimEnd().endsWith(':') === true && indentOf(code) <= indentOf(before)) return say('error.indentMissing');
  const word = CONTINUES.exec(code.trim())?.[1];
  if (word !== undefined) return say('error.elseAlone', { word });
  const tried = codes.slice(0, line - 1).findLast((it) => it.trim() !== '' && indentOf(it) <= indentOf(code));
  if (tried !== undefined && /^try\s*:/.test(tried.trim())) return say('error.tryAlone');
  return null;
}

const indentOf = (code: string): number => code.length - code.trimStart().length;

/** The line without what is in brackets. */
function outsideBrackets(code: string): string {
  let depth = 0;
  let out = '';
  for (const character of code) {
    if (CLOSING.includes(character)) depth -= 1;
    if (depth <= 0) out += character;
    if (OPENING.includes(character)) depth += 1;
  }
  return out;
}

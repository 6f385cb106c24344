import type { TextKey, TextValues } from '../../page/i18n/texts';

/** A line of a pupil's file. */
export interface Source {
  readonly text: string;
  /** Counted from 1. */
  readonly line: number;
}

/** What is wrong with a line that MicroPython calls "invalid syntax", as far as this can be found out. */
export interface SyntaxAdvice {
  readonly key: TextKey;
  readonly values: TextValues;
}

const BLOCK = /^(if|elif|else|for|while|def|class|try|except|finally|with)\b/;
const CONTINUES = /^(elif|else|except|finally)\b/;
const KEYWORDS =
  /^(and|as|assert|break|class|continue|def|del|elif|else|except|finally|for|from|global|if|import|in|is|lambda|not|or|pass|raise|return|try|while|with|yield)$/;
const OPENING = '([{';
const CLOSING = ')]}';

const say = (key: TextKey, values: TextValues = {}): SyntaxAdvice => ({ key, values });

/**
 * Looks for the usual mistakes around a line: a missing colon, bracket, quotation mark or indentation, `=` for `==`.
 * MicroPython itself says "invalid syntax" for all of them. In doubt it finds nothing.
 */
export function syntaxAdvice({ text, line }: Source): SyntaxAdvice | null {
  const lines = text.split(/\r\n?|\n/);
  const read = readUpTo(lines, line);
  const code = read.codes[line - 1] ?? '';
  if (read.openQuote !== null) return say('error.openQuote', { line: read.openQuote });
  if (read.extra !== null) return say('error.extraBracket', { bracket: read.extra });
  if (/[“”„‘’«»‹›´`]/.test(code)) return say('error.curlyQuotes');
  const [open] = read.open;
  if (open !== undefined) {
    const atEnd = readUpTo(lines, lines.length).open[0];
    return atEnd !== undefined && atEnd.line <= line
      ? say('error.openBracket', { ...atEnd })
      : say('error.missingComma');
  }
  return inLine(code.trim()) ?? aroundLine(read.codes, line);
}

/** Mistakes that show in the line itself; texts in it are empty. */
function inLine(code: string): SyntaxAdvice | null {
  if (/(^|\s)print\s+["'\w]/.test(code)) return say('error.printBrackets');
  const named = (/^(\w+)\s*=(?!=)/.exec(code) ?? /^(?:def|class|for)\s+(\w+)/.exec(code))?.[1] ?? '';
  if (KEYWORDS.test(named)) return say('error.keywordAsName', { name: named });
  const block = BLOCK.exec(code)?.[1];
  const outside = outsideBrackets(code);
  if (block !== undefined && /^(if|elif|while)$/.test(block) && /[^=!<>:+\-*/%&|^]=(?!=)/.test(outside))
    return say('error.equalsInCondition');
  if (block !== undefined && !outside.includes(':')) return say('error.missingColon', { word: block });
  const sign = /\+\+|--$|&&|\|\||=>|=<|=\s+=|!(?!=)/.exec(code)?.[0];
  return sign === undefined ? null : say('error.strangeSign', { sign });
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

interface Reading {
  /** The lines without what is in texts and comments. */
  readonly codes: readonly string[];
  /** Brackets that are open at the end of the given line, the outermost first. */
  readonly open: readonly { readonly bracket: string; readonly line: number }[];
  /** The line of a text that does not end on it. */
  readonly openQuote: number | null;
  /** A closing bracket in that line that nothing opened. */
  readonly extra: string | null;
}

/** Reads a program from its start up to a line, character by character: what is text, what is code. */
function readUpTo(lines: readonly string[], last: number): Reading {
  const codes: string[] = [];
  const open: { bracket: string; line: number }[] = [];
  let openQuote: number | null = null;
  let extra: string | null = null;
  let quote: string | null = null;
  for (let number = 1; number <= Math.min(last, lines.length); number += 1) {
    const line = lines[number - 1] ?? '';
    let code = '';
    for (let at = 0; at < line.length; at += 1) {
      const character = line.charAt(at);
      if (quote !== null) {
        if (character === '\\') at += 1;
        else if (line.startsWith(quote, at)) {
          at += quote.length - 1;
          code += '""';
          quote = null;
        }
        continue;
      }
      if (character === '#') break;
      const start = /^("""|'''|"|')/.exec(line.slice(at, at + 3))?.[0];
      if (start !== undefined) {
        quote = start;
        at += start.length - 1;
        continue;
      }
      code += character;
      if (OPENING.includes(character)) open.push({ bracket: character, line: number });
      else if (CLOSING.includes(character) && open.pop() === undefined && number === last) extra = character;
    }
    if (quote?.length === 1) {
      if (number === last) openQuote = number;
      quote = null;
    }
    codes.push(code);
  }
  return { codes, open, openQuote, extra };
}

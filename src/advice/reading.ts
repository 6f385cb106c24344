/** The brackets, each at the place of its partner. */
export const OPENING = '([{';
export const CLOSING = ')]}';

/** A program up to a line, as far as a look at its signs tells. */
export interface Reading {
  /** The lines without what is in texts and comments. */
  readonly codes: readonly string[];
  /** The column at which each line's comment begins; without one, the length of the line. */
  readonly ends: readonly number[];
  /** The number of brackets that are open where each line begins. */
  readonly depths: readonly number[];
  /** Brackets that are open at the end of the given line, the outermost first. */
  readonly open: readonly { readonly bracket: string; readonly line: number }[];
  /** The line of a text that does not end on it. */
  readonly openQuote: number | null;
  /** The line in which a triple-quoted string begins that continues past that line. */
  readonly openText: number | null;
  /** Two brackets in that line that do not fit. */
  readonly mixed: { readonly open: string; readonly close: string } | null;
  /** A closing bracket in that line that nothing opened. */
  readonly extra: string | null;
}

/** Reads a program from its start up to a line, character by character: what is text, what is code. */
export function readUpTo(lines: readonly string[], last: number): Reading {
  const codes: string[] = [];
  const ends: number[] = [];
  const depths: number[] = [];
  const open: { bracket: string; line: number }[] = [];
  let openQuote: number | null = null;
  let extra: string | null = null;
  let quote: string | null = null;
  let begun = 0;
  let mixed: Reading['mixed'] = null;
  for (let number = 1; number <= Math.min(last, lines.length); number += 1) {
    const line = lines[number - 1] ?? '';
    let code = '';
    let at = 0;
    depths.push(open.length);
    for (; at < line.length; at += 1) {
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
        begun = number;
        at += start.length - 1;
        continue;
      }
      code += character;
      if (OPENING.includes(character)) open.push({ bracket: character, line: number });
      else if (CLOSING.includes(character)) {
        const opened = open.pop()?.bracket;
        if (number !== last) continue;
        if (opened === undefined) extra = character;
        else if (OPENING.indexOf(opened) !== CLOSING.indexOf(character)) mixed = { open: opened, close: character };
      }
    }
    if (quote?.length === 1) {
      if (number === last) openQuote = number;
      quote = null;
    }
    if (quote !== null && begun === number) code += '""';
    codes.push(code);
    ends.push(Math.min(at, line.length));
  }
  return { codes, ends, depths, open, openQuote, openText: quote === null ? null : begun, extra, mixed };
}

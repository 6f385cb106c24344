/** The effect of a piece of the serial line's text on the line being written; columns are counted from 0. */
export type TerminalPiece =
  /** Printable text, with `\n` where lines end. */
  | { readonly kind: 'text'; readonly text: string }
  /** The cursor goes this many columns to the right, or to the left where it is negative. */
  | { readonly kind: 'move'; readonly by: number }
  /** The cursor goes to the beginning of the line. */
  | { readonly kind: 'return' }
  /** Deletes the text right of the cursor; with `whole` the entire line. */
  | { readonly kind: 'erase'; readonly whole: boolean }
  /** The screen is cleared. */
  | { readonly kind: 'clear' };

/** Longest escape sequence to wait for; anything longer is not one. Chosen: terminals' sequences have under 20. */
const LONGEST_ESCAPE = 32;
const CONTROL = /[\x00-\x08\x0b-\x1f\x7f]/;
const ESCAPE = /^\x1b(?:\[([0-9;?]*)([@-~])|[^[])/;

/**
 * Reads the text of a serial line as a terminal does: carriage return, backspace, and the escape sequences of VT100
 * with which MicroPython's line editor moves and erases (micropython, shared/readline/readline.c). Colours and the like
 * are left out.
 */
export class TerminalReader {
  private rest = '';

  /** The pieces of `text`. A sequence that is not yet complete waits for the next call. */
  read(text: string): readonly TerminalPiece[] {
    const all = (this.rest + text).replaceAll('\r\n', '\n');
    this.rest = '';
    const pieces: TerminalPiece[] = [];
    for (let from = 0; from < all.length;) {
      const length = this.take(all, from, pieces);
      if (length === 0) {
        this.rest = all.slice(from);
        break;
      }
      from += length;
    }
    return pieces;
  }

  /** Forgets an unfinished sequence. */
  clear(): void {
    this.rest = '';
  }

  /** Adds the piece that begins at `from` and returns its length; 0: it is not complete. */
  private take(all: string, from: number, pieces: TerminalPiece[]): number {
    const tail = from === 0 ? all : all.slice(from);
    const plain = tail.search(CONTROL);
    if (plain !== 0) {
      const text = plain < 0 ? tail : tail.slice(0, plain);
      pieces.push({ kind: 'text', text });
      return text.length;
    }
    const sign = tail.charAt(0);
    if (sign === '\x1b') return takeEscape(tail, pieces);
    if (sign === '\r') {
      if (tail.length === 1) return 0; // its line feed may be in transit
      pieces.push({ kind: 'return' });
    } else if (sign === '\b') {
      pieces.push({ kind: 'move', by: -1 });
    }
    return 1;
  }
}

function takeEscape(tail: string, pieces: TerminalPiece[]): number {
  const match = ESCAPE.exec(tail);
  if (match === null) return tail.length > LONGEST_ESCAPE ? 1 : 0;
  const [whole, numbers = '', letter] = match;
  const count = Math.max(1, Number.parseInt(numbers, 10) || 1);
  if (letter === 'D') pieces.push({ kind: 'move', by: -count });
  else if (letter === 'C') pieces.push({ kind: 'move', by: count });
  else if (letter === 'K' && (numbers === '' || numbers === '0')) pieces.push({ kind: 'erase', whole: false });
  else if (letter === 'K') pieces.push({ kind: 'erase', whole: true });
  else if (letter === 'J' && (numbers === '2' || numbers === '3')) pieces.push({ kind: 'clear' });
  return whole.length;
}

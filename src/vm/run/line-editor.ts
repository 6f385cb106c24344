const Key = {
  CTRL_A: 1,
  CTRL_C: 3,
  CTRL_E: 5,
  BACKSPACE: 8,
  TAB: 9,
  NEWLINE: 10,
  RETURN: 13,
  ESCAPE: 27,
  SPACE: 32,
  DELETE: 127,
} as const;

const INDENT = '    ';
/** MICROPY_READLINE_HISTORY_SIZE: MicroPython py/mpconfig.h. */
const HISTORY_LINES = 8;

/** Meaning of a key beyond the line itself: the line is complete, Tab, or a control key for others to handle. */
export type Signal = 'line' | 'tab' | 'ctrl-a' | 'ctrl-b' | 'ctrl-c' | 'ctrl-d' | 'ctrl-e';

const CONTROLS: readonly Signal[] = ['ctrl-a', 'ctrl-b', 'ctrl-c', 'ctrl-d', 'ctrl-e'];

/** Position within the keys of an escape sequence (arrows, Home, …). */
type Escape = 'none' | 'escape' | 'bracket' | 'digit' | 'letter-o';

/**
 * Reads a line key by key, echoing what a terminal needs to show it: cursor keys, Home, End, backspace, delete, a
 * history of 8 lines, automatic indentation. Keys and answers are those of MicroPython's shared/readline/readline.c (as
 * micropython-microbit-v2 builds it: without the Emacs keys), except that letters beyond ASCII are kept (the device
 * drops them) and a newline ends a line as Return does.
 */
export class LineEditor {
  private letters: string[] = [];
  private cursor = 0;
  private prompt = '';
  private escape: Escape = 'none';
  private digit = 0;
  private isIndented = false;
  private indents = true;
  private lastWasReturn = false;
  private readonly history: string[] = [];
  private place = -1;
  private decoder = new TextDecoder();

  /** @param send receives what goes to the terminal */
  constructor(private readonly send: (text: string) => void) {}

  /** The line so far. */
  get text(): string {
    return this.letters.join('');
  }

  /** The line up to the cursor. */
  get textToCursor(): string {
    return this.letters.slice(0, this.cursor).join('');
  }

  /**
   * Begins a line.
   *
   * @param before the lines that it continues, each with its newline; they determine its indentation
   */
  begin(prompt: string, before = ''): void {
    this.letters = [];
    this.cursor = 0;
    this.prompt = prompt;
    this.escape = 'none';
    this.place = -1;
    this.isIndented = false;
    if (before === '') this.indents = true;
    this.send(prompt);
    const depth = this.indents ? indentAfter(before) : 0;
    if (depth === 0) return;
    this.type(INDENT.repeat(depth));
    this.isIndented = true;
  }

  /** Takes one byte. @returns its further meaning, or `null` */
  key(byte: number): Signal | null {
    // Return and newline one after the other are one end of line, not two.
    const isRestOfReturn = byte === Key.NEWLINE && this.lastWasReturn;
    this.lastWasReturn = byte === Key.RETURN;
    if (isRestOfReturn) return null;
    const wasIndented = this.isIndented;
    this.isIndented = false;
    if (this.escape !== 'none') return this.sequence(byte);
    const control = CONTROLS[byte - Key.CTRL_A];
    if (control && (this.letters.length === 0 || byte === Key.CTRL_C)) return control;
    switch (byte) {
      case Key.CTRL_A:
        return this.moveTo(0);
      case Key.CTRL_E:
        return this.moveTo(this.letters.length);
      case Key.RETURN:
      case Key.NEWLINE:
        return this.finish();
      case Key.ESCAPE:
        this.escape = 'escape';
        return null;
      case Key.BACKSPACE:
      case Key.DELETE:
        return this.rubOut();
      case Key.TAB:
        return this.tab(wasIndented);
      default:
        if (byte < Key.SPACE) return null;
        if (byte === Key.SPACE && wasIndented) return this.unindent();
        return this.type(this.decoder.decode(Uint8Array.of(byte), { stream: true }));
    }
  }

  /** Inserts text at the cursor, as if it was typed. */
  type(text: string): null {
    const letters = Array.from(text);
    if (letters.length === 0) return null;
    this.letters.splice(this.cursor, 0, ...letters);
    this.cursor += letters.length;
    this.send(text);
    this.redrawRest();
    return null;
  }

  /** Shows prompt and line again, below other output. */
  showAgain(): void {
    this.send(this.prompt + this.textToCursor);
    this.redrawRest();
  }

  private finish(): Signal {
    this.send('\r\n');
    const { text } = this;
    if (text !== '' && this.history[0] !== text) {
      this.history.unshift(text);
      this.history.length = Math.min(this.history.length, HISTORY_LINES);
    }
    return 'line';
  }

  private tab(wasIndented: boolean): Signal | null {
    if (wasIndented) {
      this.indents = false;
      return null;
    }
    const before = this.letters[this.cursor - 1];
    if (before === ' ' || (before === undefined && this.prompt.startsWith('.'))) return this.type(INDENT);
    return 'tab';
  }

  /** A space after an automatic indentation leaves one space of it, and switches the indentation off. */
  private unindent(): null {
    this.indents = false;
    return this.cut(this.cursor - (INDENT.length - 1), INDENT.length - 1);
  }

  private rubOut(): null {
    if (this.cursor === 0) return null;
    const isIndent = this.letters.slice(0, this.cursor).every((letter) => letter === ' ');
    const count = isIndent && this.cursor >= INDENT.length ? INDENT.length : 1;
    return this.cut(this.cursor - count, count);
  }

  private cut(place: number, count: number): null {
    this.back(this.cursor - place);
    this.letters.splice(place, count);
    this.cursor = place;
    this.send('\x1b[K');
    this.redrawRest();
    return null;
  }

  private redrawRest(): void {
    const rest = this.letters.slice(this.cursor);
    if (rest.length === 0) return;
    this.send(rest.join(''));
    this.back(rest.length);
  }

  private back(count: number): void {
    if (count > 0) this.send(count <= 4 ? '\b'.repeat(count) : `\x1b[${count}D`);
  }

  private moveTo(place: number): null {
    const to = Math.max(0, Math.min(place, this.letters.length));
    if (to < this.cursor) this.back(this.cursor - to);
    else this.send(this.letters.slice(this.cursor, to).join(''));
    this.cursor = to;
    return null;
  }

  private sequence(byte: number): null {
    const key = String.fromCharCode(byte);
    const state = this.escape;
    this.escape = 'none';
    if (state === 'escape') {
      if (key === '[') this.escape = 'bracket';
      if (key === 'O') this.escape = 'letter-o';
    } else if (state === 'bracket' && key >= '0' && key <= '9') {
      this.escape = 'digit';
      this.digit = Number(key);
    } else if (state === 'digit') {
      if (key === '~') this.tilde(this.digit);
    } else {
      this.arrow(key);
    }
    return null;
  }

  private arrow(key: string): null {
    switch (key) {
      case 'A':
        return this.recall(this.place + 1);
      case 'B':
        return this.recall(this.place - 1);
      case 'C':
        return this.moveTo(this.cursor + 1);
      case 'D':
        return this.moveTo(this.cursor - 1);
      case 'H':
        return this.moveTo(0);
      case 'F':
        return this.moveTo(this.letters.length);
      default:
        return null;
    }
  }

  /** Home, Delete and End of terminals that send `ESC [ 1 ~`. */
  private tilde(digit: number): null {
    if (digit === 1 || digit === 7) return this.moveTo(0);
    if (digit === 4 || digit === 8) return this.moveTo(this.letters.length);
    if (digit === 3 && this.cursor < this.letters.length) return this.cut(this.cursor, 1);
    return null;
  }

  private recall(place: number): null {
    const line = place < 0 ? '' : this.history[place];
    if (line === undefined || (place < 0 && this.place < 0)) return null;
    this.place = place;
    this.cut(0, this.letters.length);
    return this.type(line);
  }
}

/** Indentation of the next line in steps: as the last one, one more after a colon, none after two blank lines. */
function indentAfter(before: string): number {
  if (!before.endsWith('\n')) return 0;
  const lines = before.slice(0, -1).split('\n');
  const last = lines[lines.length - 1] ?? '';
  const isBlank = (line: string | undefined): boolean => line !== undefined && line.trim() === '';
  if (lines.length > 1 && isBlank(last) && isBlank(lines[lines.length - 2])) return 0;
  const spaces = last.length - last.trimStart().length;
  return Math.floor(spaces / INDENT.length) + (last.endsWith(':') ? 1 : 0);
}

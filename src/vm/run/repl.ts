import type { ConsolePort } from './console-port';
import { LineEditor, type Signal } from './line-editor';
import { wantsMore } from './repl-input';

/** The REPL's next request to Python. */
export type Request =
  /** Runs a statement; the value of an expression is printed. */
  | { readonly type: 'statement'; readonly source: string }
  /** Runs a program of several lines that a tool sends. */
  | { readonly type: 'program'; readonly source: string }
  /** The same, pasted by a person: values of expressions are printed. */
  | { readonly type: 'pasted'; readonly source: string }
  /** Asks for the names of the object `path` (`a.b`; empty: the program's own), for Tab to complete. */
  | { readonly type: 'names'; readonly path: string }
  | { readonly type: 'reboot' };

const PROMPT = '>>> ';
const MORE = '... ';
const PASTE = '=== ';
const RAW_PROMPT = '>';
const END = '\x04';

const NAME = /[A-Za-z0-9_.]*$/;
/** MicroPython py/repl.c: completions stand in columns of 16, four a line. */
const COLUMN = 16;
const LINE_COLUMNS = 64;

/**
 * The dialogue on the serial line after the program's end, byte for byte as in MicroPython's shared/runtime/pyexec.c:
 * prompt and line, paste mode, raw mode for tools. It knows no Python: it collects what to run and says what the
 * terminal shows. It survives a soft reboot, as the device's mode does.
 */
export class Repl {
  private state: 'asleep' | 'line' | 'paste' | 'raw' | 'busy' = 'asleep';
  private mode: 'friendly' | 'raw' = 'friendly';
  private readonly editor: LineEditor;
  /** The lines of a compound statement so far, or the text that was pasted or sent in raw mode. */
  private before = '';
  private raw: number[] = [];
  private lastWasReturn = false;
  private request: Request | null = null;
  private failed = false;
  /** Number of bytes received when the program ended: without later input, the REPL stays asleep. */
  private wakeAfter = 0;

  constructor(
    private readonly port: ConsolePort,
    private readonly banner: string,
    private readonly greetsAtOnce: boolean,
  ) {
    this.editor = new LineEditor((text) => this.send(text));
  }

  /** True while tools talk to the board: then main.py does not run after a soft reboot. */
  get isRaw(): boolean {
    return this.mode === 'raw';
  }

  /** True until it has greeted. */
  get isAsleep(): boolean {
    return this.state === 'asleep';
  }

  /** The program has ended: the REPL receives everything typed from now on. */
  programEnded(): void {
    this.state = 'asleep';
    this.wakeAfter = this.greetsAtOnce || this.mode === 'raw' ? -1 : this.port.received;
  }

  /** The request is done: the next prompt. */
  listen(): void {
    if (this.state !== 'busy') return;
    if (this.mode === 'raw') {
      this.send(this.failed ? END : END + END);
      this.beginRaw();
    } else this.beginLine();
  }

  /** The request ends with an exception, whose traceback follows. */
  fail(): void {
    this.failed = true;
    if (this.mode === 'raw') this.send(END);
  }

  /** Takes typed input, up to the next request. */
  next(): Request | null {
    if (this.state === 'asleep' && this.port.received > this.wakeAfter) this.greet();
    while (this.request === null && this.state !== 'asleep') {
      const byte = this.port.take();
      if (byte === undefined) return null;
      if (this.state === 'raw') this.rawByte(byte);
      else if (this.state === 'paste') this.pasteByte(byte);
      else this.lineByte(byte);
    }
    const { request } = this;
    this.request = null;
    return request;
  }

  /** The names that begin like the one before the cursor: a single one is completed, several are listed. */
  complete(names: readonly string[]): void {
    this.state = 'line';
    const start = lastPart(this.editor.textToCursor);
    const found = names.filter((name) => name.startsWith(start) && (start !== '' || !name.startsWith('_'))).sort();
    const isFirst = this.editor.textToCursor === start && this.before === '';
    if (found.length === 0 && isFirst && 'import '.startsWith(start)) found.push('import ');
    const common = commonStart(found);
    if (found.length === 1 || common.length > start.length) this.editor.type(common.slice(start.length));
    else if (found.length > 1) {
      this.send(columns(found));
      this.editor.showAgain();
    }
  }

  private greet(): void {
    if (this.mode === 'raw') return this.greetRaw();
    this.send(`${this.banner}\r\nType "help()" for more information.\r\n`);
    this.beginLine();
  }

  private greetRaw(): void {
    this.mode = 'raw';
    this.send('raw REPL; CTRL-B to exit\r\n');
    this.beginRaw();
  }

  private beginLine(): void {
    this.state = 'line';
    this.before = '';
    this.editor.begin(PROMPT);
  }

  private beginRaw(): void {
    this.state = 'raw';
    this.raw = [];
    this.send(RAW_PROMPT);
  }

  private ask(request: Request): void {
    this.request = request;
    this.state = 'busy';
    this.failed = false;
  }

  private lineByte(byte: number): void {
    const signal = this.editor.key(byte);
    if (signal === 'tab') this.ask({ type: 'names', path: pathOf(this.editor.textToCursor) });
    else if (signal === 'line') this.addLine();
    else if (signal === 'ctrl-c') this.restart();
    else if (signal !== null) this.control(signal);
  }

  private restart(): void {
    this.send('\r\n');
    this.beginLine();
  }

  private addLine(): void {
    const source = this.before + this.editor.text;
    if (source === '') return this.beginLine();
    if (!wantsMore(source)) return this.ask({ type: 'statement', source });
    this.before = `${source}\n`;
    this.editor.begin(MORE, this.before);
  }

  /** A control key on an empty line. Within a compound statement all but Ctrl-D end the line like Return. */
  private control(signal: Signal): void {
    if (this.before !== '') {
      if (signal === 'ctrl-d') this.ask({ type: 'statement', source: this.before });
      else this.addLine();
      return;
    }
    if (signal === 'ctrl-a') {
      this.send('\r\n');
      this.greetRaw();
    } else if (signal === 'ctrl-b') {
      this.send('\r\n');
      this.greet();
    } else if (signal === 'ctrl-d') {
      this.send('\r\n');
      this.ask({ type: 'reboot' });
    } else {
      this.send(`\r\npaste mode; Ctrl-C to cancel, Ctrl-D to finish\r\n${PASTE}`);
      this.state = 'paste';
      this.raw = [];
      this.lastWasReturn = false;
    }
  }

  private pasteByte(byte: number): void {
    if (byte === 3) return this.restart();
    if (byte === 4) {
      this.send('\r\n');
      return this.ask({ type: 'pasted', source: textOf(this.raw) });
    }
    const isEnd = byte === 10 || byte === 13;
    // Return and newline one after the other are one end of line, not two.
    const isRest = byte === 10 && this.lastWasReturn;
    this.lastWasReturn = byte === 13;
    if (isRest) return;
    this.raw.push(isEnd ? 10 : byte);
    if (isEnd) this.send(`\r\n${PASTE}`);
    else this.port.write(Uint8Array.of(byte));
  }

  private rawByte(byte: number): void {
    if (byte === 1) {
      const isPasteQuestion = this.raw.length === 2 && this.raw[0] === 5;
      if (!isPasteQuestion) return this.greetRaw();
      // A tool requests a mode of sending that this firmware does not have: it falls back to the plain one.
      this.send('R\x00');
      return this.beginRaw();
    }
    if (byte === 2) {
      this.mode = 'friendly';
      this.send('\r\n');
      return this.greet();
    }
    if (byte === 3) this.raw = [];
    else if (byte !== 4) this.raw.push(byte);
    else if (this.raw.length === 0) {
      this.send('OK\r\n');
      this.ask({ type: 'reboot' });
    } else {
      this.send('OK');
      this.ask({ type: 'program', source: textOf(this.raw) });
    }
  }

  private send(text: string): void {
    this.port.write(new TextEncoder().encode(text));
  }
}

const textOf = (bytes: readonly number[]): string => new TextDecoder().decode(Uint8Array.from(bytes));

/** `a.b` of `print(a.b.c`: the object whose names are requested; empty for the program's own. */
const pathOf = (line: string): string => (NAME.exec(line)?.[0] ?? '').split('.').slice(0, -1).join('.');

const lastPart = (line: string): string => (NAME.exec(line)?.[0] ?? '').split('.').pop() ?? '';

function commonStart(names: readonly string[]): string {
  const [first = ''] = names;
  let length = first.length;
  for (const name of names) while (!name.startsWith(first.slice(0, length))) length--;
  return first.slice(0, length);
}

function columns(names: readonly string[]): string {
  let text = '';
  let used = LINE_COLUMNS;
  for (const name of names) {
    let gap = Math.ceil(used / COLUMN) * COLUMN - used;
    if (gap < 2) gap += COLUMN;
    if (used + gap + name.length <= LINE_COLUMNS) {
      text += ' '.repeat(gap) + name;
      used += gap + name.length;
    } else {
      text += `\r\n${name}`;
      used = name.length;
    }
  }
  return `${text}\r\n`;
}

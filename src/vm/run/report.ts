import { VmFault } from './engine';
import { textOf } from './arguments';
import type { SyscallTable } from './syscall';

/** How a program ended. */
export interface VmEnd {
  /** `stopped`: by KeyboardInterrupt; `panic`: by `panic()`; `fault`: MicroPython itself could not go on. */
  readonly kind: 'finished' | 'exception' | 'stopped' | 'panic' | 'fault';
  readonly exception: VmException | null;
}

/** An exception that left the program, as the console shows it. */
export interface VmException {
  /** Its class, `NameError`. */
  readonly type: string;
  readonly message: string;
  /** The line where it was raised, in the innermost function of the pupil's files; `null` if no line is known. */
  readonly line: number | null;
  readonly traceback: string;
}

/** A program with fewer characters fits: memory ran out later. Measured with lines of assignments. */
const LONG_PROGRAM = 12_000;
const NEWLINE = 10;
const LINE_END = [13, 10];
/** Decorators that make machine code: MicroPython py/compile.c. */
const MACHINE_CODE = /^\s*@micropython\.(asm_thumb|native|viper)\b/;

/** Collects what the program prints and how it ends. */
export class Report {
  private readonly decoder = new TextDecoder();
  private tracebackFrom: string[] | null = null;
  /** The program was stopped: the console text of its traceback waits here until its exception is known. */
  private held: string[] | null = null;
  private end: VmEnd | null = null;

  /**
   * @param tell receives the console's text
   * @param readFile gives the text of a file on the board; empty if it does not exist
   * @param filesHint what a real board would say about the files that the run starts with
   */
  constructor(
    private readonly tell: (text: string) => void,
    private readonly readFile: (name: string) => string,
    private readonly filesHint: string | null,
  ) {}

  /** True while a traceback is printed on the program's end. */
  get isReporting(): boolean {
    return this.tracebackFrom !== null;
  }

  get ended(): VmEnd | null {
    return this.end;
  }

  /**
   * Bytes that Python prints.
   *
   * @param asOnTheWire ends lines with a carriage return and a newline, as a terminal needs it, while the REPL is used.
   *   Output of a program keeps its plain newlines.
   */
  print(bytes: Uint8Array, asOnTheWire: boolean): void {
    if (!asOnTheWire || !bytes.includes(NEWLINE)) return this.write(bytes);
    this.write(Uint8Array.from(Array.from(bytes).flatMap((byte) => (byte === NEWLINE ? LINE_END : [byte]))));
  }

  /** Bytes for the console, possibly in the middle of a character. */
  write(bytes: Uint8Array): void {
    const text = this.decoder.decode(bytes, { stream: true });
    this.tracebackFrom?.push(text);
    if (this.tracebackFrom !== null && this.held !== null) this.held.push(text);
    else this.tell(text);
  }

  /** From now on the traceback of a KeyboardInterrupt is not shown: a user who presses Stop has not found an error. */
  hideInterrupt(): void {
    this.held ??= [];
  }

  /** A program starts again, after a reset. */
  restart(): void {
    this.end = null;
    this.tracebackFrom = null;
  }

  /**
   * The functions by which the library's runner reports how the program ended: report_begin() before the traceback
   * is printed, report_end(type, message) after it.
   */
  syscalls(): SyscallTable {
    return {
      report_begin: () => {
        this.tracebackFrom = [];
        if (this.held !== null) this.held = [];
        return null;
      },
      report_end: (type, message) => {
        const traceback = this.tracebackFrom?.join('') ?? '';
        this.tracebackFrom = null;
        if (this.held !== null && textOf(type) !== 'KeyboardInterrupt') this.tell(this.held.join(''));
        this.fail(textOf(type), textOf(message), traceback);
        return null;
      },
    };
  }

  /** The program has returned: unless it failed before, it finished. */
  finish(): void {
    this.end ??= { kind: 'finished', exception: null };
  }

  /** The program called `panic()`. */
  panic(): void {
    this.end ??= { kind: 'panic', exception: null };
  }

  /** MicroPython or our side of it failed. */
  fault(thrown: unknown): void {
    const text = faultText(thrown);
    this.tell(`${text}\n`);
    this.end ??= { kind: 'fault', exception: { type: 'InternalError', message: text, line: null, traceback: text } };
  }

  /** An addition to the device's own words, for readers of the console; `null` if those say it all. */
  private hint(type: string, message: string, place: Place | null): string | null {
    const length = this.readFile('main.py').length;
    // Without a line, memory was used up before the program began, while it was being compiled.
    if (type === 'MemoryError' && place === null && length > LONG_PROGRAM)
      return `main.py: the program is too long for the board. It has ${length} characters.`;
    // The board accepts more files than it has room for, but then the program can write none.
    if (type === 'OSError' && message.includes('ENOSPC')) return this.filesHint;
    if (type !== 'SyntaxError' || place === null) return null;
    const line = this.readFile(place.file).split('\n')[place.line - 1] ?? '';
    const kind = MACHINE_CODE.exec(line)?.[1];
    if (kind === undefined) return null;
    const why = kind === 'asm_thumb' ? 'is not simulated' : 'is not in this firmware';
    return `${place.file}, line ${place.line}: machine code (@micropython.${kind}) ${why}.`;
  }

  private fail(type: string, message: string, traceback: string): void {
    const place = innermostPlace(traceback);
    const exception = { type, message, line: place?.line ?? null, traceback };
    const hint = this.hint(type, message, place);
    if (hint !== null) this.tell(`${hint}\n`);
    this.end ??= { kind: type === 'KeyboardInterrupt' ? 'stopped' : 'exception', exception };
  }
}

interface Place {
  readonly file: string;
  readonly line: number;
}

/** The place of the last frame: MicroPython prints the innermost call last. */
function innermostPlace(traceback: string): Place | null {
  const places = [...traceback.matchAll(/^ {2}File "([^"]*)", line (\d+)/gm)];
  const last = places[places.length - 1];
  return last ? { file: last[1] ?? '', line: Number(last[2]) } : null;
}

/** The text of a fault. Each engine words a wild address or a full stack in its own way; ours is always the same. */
function faultText(thrown: unknown): string {
  if (thrown instanceof VmFault) return thrown.message;
  const isCrash = thrown instanceof WebAssembly.RuntimeError || isStackFull(thrown);
  if (isCrash)
    return 'MicroPython has crashed: the program asks for something that breaks it, on the board too. Press Run to begin anew.';
  return `Internal error: ${thrown instanceof Error ? thrown.message : String(thrown)}`;
}

/** True for an overflow of the stack, which in Firefox is an error of a class that cannot be named here. */
const isStackFull = (thrown: unknown): boolean =>
  thrown instanceof RangeError || (thrown instanceof Error && thrown.name === 'InternalError');

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
  /** The line where it arose, in the innermost function of the pupil's files; `null` when no line is known. */
  readonly line: number | null;
  readonly traceback: string;
}

/** A program of fewer characters fits, whatever is in it; then memory ran out later. Measured with lines of assignments. */
const LONG_PROGRAM = 12_000;

/** Collects what the program prints and how it ends. */
export class Report {
  private readonly decoder = new TextDecoder();
  private tracebackFrom: string[] | null = null;
  private end: VmEnd | null = null;
  /**
   * @param tell receives what the console shows
   * @param programCharacters the length of main.py
   */
  constructor(
    private readonly tell: (text: string) => void,
    private readonly programCharacters: number,
  ) {}

  get ended(): VmEnd | null {
    return this.end;
  }

  /** Bytes that the program prints, possibly in the middle of a character. */
  write(bytes: Uint8Array): void {
    const text = this.decoder.decode(bytes, { stream: true });
    this.tracebackFrom?.push(text);
    this.tell(text);
  }

  /**
   * The functions through which the library's runner tells how the program ended.
   *
   * @param endProgram lets nothing of it run any more
   */
  syscalls(endProgram: () => void): SyscallTable {
    return {
      report_begin: () => {
        this.tracebackFrom = [];
        return null;
      },
      report_end: (type, message) => {
        const traceback = this.tracebackFrom?.join('') ?? '';
        this.tracebackFrom = null;
        this.fail(textOf(type), textOf(message), traceback);
        return null;
      },
      finish: () => {
        endProgram();
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

  /** MicroPython, or our side of it, broke. */
  fault(thrown: unknown): void {
    const isKnown = thrown instanceof VmFault;
    const message = thrown instanceof Error ? thrown.message : String(thrown);
    const text = isKnown ? message : `Internal error: ${message}`;
    this.tell(`${text}\n`);
    this.end ??= { kind: 'fault', exception: { type: 'InternalError', message: text, line: null, traceback: text } };
  }

  /** Without a line, memory was used up before the program began: while it was being translated. */
  private tooLong(): string {
    return `the program is too long for the board. It has ${this.programCharacters} characters; about 20000 fit.`;
  }

  private fail(type: string, message: string, traceback: string): void {
    const exception = { type, message, line: innermostLine(traceback), traceback };
    if (type === 'MemoryError' && exception.line === null && this.programCharacters > LONG_PROGRAM)
      this.tell(`main.py: ${this.tooLong()}\n`);
    this.end ??= { kind: type === 'KeyboardInterrupt' ? 'stopped' : 'exception', exception };
  }
}

/** The line of the last frame: MicroPython prints the innermost call last. */
function innermostLine(traceback: string): number | null {
  const lines = [...traceback.matchAll(/^ {2}File "[^"]*", line (\d+)/gm)];
  const last = lines[lines.length - 1]?.[1];
  return last === undefined ? null : Number(last);
}

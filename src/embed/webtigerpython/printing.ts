import { Printed } from './printed';

/** How long a possible last traceback is held back, in ms. Chosen: the program's end is reported long before. */
export const HOLD_MS = 1000;

/** How a program ended, as far as it matters here. */
export interface PrintEnd {
  /** The traceback that ended it, or `null`. */
  readonly traceback: string | null;
  /** By Stop: its exception is then not an error. */
  readonly isStopped: boolean;
}

/** The whole output of a program. */
export interface PrintWhole {
  /** The traceback that ended it; `null` if none did, or if Stop was pressed. */
  readonly error: string | null;
  readonly whole: string;
}

/** The output of a page's programs, one after the other, with the traceback that ends one kept apart. */
export class Printing {
  private printed: Printed | null = null;

  /** @param output receives the next piece of a program's output; never empty */
  constructor(private readonly output: (text: string) => void) {}

  /** True if a program runs; later output of the REPL is ignored. */
  get isLive(): boolean {
    return this.printed !== null;
  }

  /** A program begins. */
  begin(): void {
    this.printed = new Printed();
  }

  /** Takes the next piece of output. */
  add(text: string): void {
    this.say(this.printed?.add(text) ?? '');
  }

  /** Nothing was printed for `HOLD_MS`, and the program goes on: what was held back is not the last traceback. */
  release(): void {
    this.say(this.printed?.release() ?? '');
  }

  /** The program is over: sends the rest of its output. @returns its error and its whole output; `null` if none ran */
  end({ traceback, isStopped }: PrintEnd): PrintWhole | null {
    const { printed } = this;
    if (printed === null) return null;
    this.printed = null;
    this.say(printed.end(traceback));
    return { error: isStopped ? null : (traceback?.replaceAll('\r\n', '\n') ?? null), whole: printed.whole };
  }

  /** There is no listener any more: further output is dropped. */
  forget(): void {
    this.printed = null;
  }

  private say(text: string): void {
    if (text !== '') this.output(text);
  }
}

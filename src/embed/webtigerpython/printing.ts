import { Printed } from './printed';

/** How long what looks like the last traceback is held back while the program goes on, in ms. Chosen: its end is told long before, also on a busy machine. */
export const HOLD_MS = 1000;

/** How a program ended, as far as it matters here. */
export interface PrintEnd {
  /** The traceback that ended it, or `null`. */
  readonly traceback: string | null;
  /** By Stop: what it then says is no error. */
  readonly isStopped: boolean;
}

/** What a program has printed in all. */
export interface PrintWhole {
  /** The traceback that ended it; `null`: none did, or somebody stopped it. */
  readonly error: string | null;
  readonly whole: string;
}

/** What the programs of a page print, one after the other, with the traceback that ends one kept apart. */
export class Printing {
  private printed: Printed | null = null;

  /** @param output hears the next piece of what a program prints; never empty */
  constructor(private readonly output: (text: string) => void) {}

  /** Whether a program runs; what the REPL prints afterwards is nobody's business. */
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

  /** Nothing was printed for `HOLD_MS`, and the program goes on: what was held back is no last traceback. */
  release(): void {
    this.say(this.printed?.release() ?? '');
  }

  /** The program is over: tells the rest of what it printed. @returns its error and all of it once more; `null`: none ran */
  end({ traceback, isStopped }: PrintEnd): PrintWhole | null {
    const { printed } = this;
    if (printed === null) return null;
    this.printed = null;
    this.say(printed.end(traceback));
    return { error: isStopped ? null : (traceback?.replaceAll('\r\n', '\n') ?? null), whole: printed.whole };
  }

  /** Nobody listens any more: what the program still has to say is not told. */
  forget(): void {
    this.printed = null;
  }

  private say(text: string): void {
    if (text !== '') this.output(text);
  }
}

/** The first line of a traceback. */
const HEAD = 'Traceback (most recent call last):\n';

/** A complete traceback: its head, the lines below, and the line with the exception. */
const WHOLE = /^Traceback \(most recent call last\):\n(?: {2}.*\n)+\S.*\n/;

/** Maximum that is held back, in characters. Chosen: the deepest recursion of a board has a tenth of it. */
const HELD_CHARACTERS = 50_000;

/** Maximum of a run that `whole` keeps, in characters. Chosen: a minute of the fastest printing. */
export const KEPT_CHARACTERS = 200_000;

/**
 * The output of a program, with the traceback that ends it kept apart: on the serial line both come in one stream. A
 * possible beginning of that traceback is held back until it is certain. Lines end in `\n`.
 */
export class Printed {
  private held = '';
  private kept = '';

  /** All output so far; if more than `KEPT_CHARACTERS`, its last part. */
  get whole(): string {
    return this.kept.slice(-KEPT_CHARACTERS);
  }

  /** Takes the next piece. @returns what is certainly not part of the last traceback */
  add(piece: string): string {
    const text = (this.held + piece).replaceAll('\r\n', '\n');
    const from = heldFrom(text);
    this.held = text.slice(from);
    return this.keep(text.slice(0, from));
  }

  /** The program is over. @returns what was held back, without the traceback that ended it; `whole` includes it */
  end(traceback: string | null): string {
    const error = traceback?.replaceAll('\r\n', '\n') ?? '';
    const rest = this.keep(error === '' ? this.held : withoutEnd(this.held, error));
    this.held = '';
    this.keep(error);
    return rest;
  }

  /** Gives up waiting: the program goes on after what only looked like its end. @returns what was held back */
  release(): string {
    const { held } = this;
    this.held = '';
    return this.keep(held);
  }

  private keep(text: string): string {
    this.kept += text;
    // Cut only now and then: every cut copies all of it.
    if (this.kept.length > 2 * KEPT_CHARACTERS) this.kept = this.kept.slice(-KEPT_CHARACTERS);
    return text;
  }
}

/** Start of the part that may belong to the last traceback; the length of the text if there is none. */
function heldFrom(text: string): number {
  let from = startOfTraceback(text, 0);
  for (;;) {
    if (text.length - from > HELD_CHARACTERS) return text.length;
    const whole = WHOLE.exec(text.slice(from))?.[0];
    // If something follows it, the program itself printed it and went on.
    if (whole === undefined || from + whole.length === text.length) return from;
    from = startOfTraceback(text, from + whole.length);
  }
}

/** Start of the next traceback, or of a possible one at the end; else the end, before a `\r` that waits for `\n`. */
function startOfTraceback(text: string, after: number): number {
  const found = text.indexOf(HEAD, after);
  if (found >= 0) return found;
  for (let from = Math.max(after, text.length - HEAD.length); from < text.length; from += 1) {
    if (HEAD.startsWith(text.slice(from).replace(/\r$/, '\n'))) return from;
  }
  return text.endsWith('\r') && text.length > after ? text.length - 1 : text.length;
}

function withoutEnd(text: string, end: string): string {
  const [trimmed, wanted] = [text.trimEnd(), end.trimEnd()];
  return trimmed.endsWith(wanted) ? trimmed.slice(0, trimmed.length - wanted.length) : text;
}

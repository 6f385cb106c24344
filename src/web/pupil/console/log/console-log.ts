import type { AtTable } from '#advice/at-table';

import type { TextKey } from '../../../kit/i18n/texts';
import type { ErrorReport, Failure } from '../advice/error-advice';
import { TerminalReader, type TerminalPiece } from './terminal-text';

/**
 * A piece of program output that looks the same throughout: `error` is a traceback, `quiet` one of a stopped program.
 */
export type TextTone = 'plain' | 'error' | 'quiet';

/** One thing in the console. `id` is stable while it is shown. `fit`: the robot did not fit as the run began. */
export type ConsoleEntry =
  | { readonly id: number; readonly kind: 'run'; readonly number: number }
  | {
      readonly id: number;
      readonly kind: 'text';
      readonly tone: TextTone;
      readonly text: string;
      readonly lines: number;
    }
  | { readonly id: number; readonly kind: 'note'; readonly key: TextKey }
  | { readonly id: number; readonly kind: 'fit' }
  | { readonly id: number; readonly kind: 'error'; readonly place: ErrorPlace | null; readonly report: ErrorReport };

/** Place of an error: a file of the pupil and its line, counted from 1. */
export interface ErrorPlace {
  readonly file: string;
  readonly line: number;
}

/** Limits of the console: enough to scroll back, little enough for a school tablet. */
export const CONSOLE_LIMITS = {
  lines: 5000,
  lineCharacters: 2000,
  /** Chosen: the last 50 runs or so. Every entry is some nodes on the page, however short it is. */
  entries: 200,
  entryLines: 100,
  entryCharacters: 8000,
} as const;

const TRACEBACK = 'Traceback (most recent call last):';
/** Mark in the traceback of a line typed at the REPL. */
const TYPED = 'File "<stdin>"';

type NewEntry =
  | { readonly kind: 'run'; readonly number: number }
  | { readonly kind: 'note'; readonly key: TextKey }
  | { readonly kind: 'fit' }
  | { readonly kind: 'error'; readonly place: ErrorPlace | null; readonly report: ErrorReport };
/** A text entry while `write` adds to it; afterwards it never changes. */
type OpenEntry = { -readonly [K in keyof TextEntry]: TextEntry[K] };
type TextEntry = Extract<ConsoleEntry, { kind: 'text' }>;

/**
 * The console's memory: bounded, whatever a program prints. Text is kept in entries of at most 100 lines, so that new
 * output touches one of them and the oldest ones can be dropped whole.
 */
export class ConsoleLog {
  private kept: ConsoleEntry[] = [];
  private lines = 0;
  private nextId = 1;
  private tone: TextTone = 'plain';
  /** The traceback that is being written. */
  private traceback = '';
  private lineStart = true;
  private lineLength = 0;
  /** Column of the next character in the line being written; line editing moves it back. */
  private column = 0;
  private open: OpenEntry | null = null;
  private cut = false;
  private readonly reader = new TerminalReader();

  /** @param table what is plugged in, for errors of a robot that does not answer */
  constructor(private readonly table: () => AtTable | null = () => null) {}

  /** Everything kept, oldest first; a new array after every change. */
  get entries(): readonly ConsoleEntry[] {
    return this.kept;
  }

  /** True if older output has been dropped. */
  get isCut(): boolean {
    return this.cut;
  }

  /**
   * Adds output of the program as a terminal shows it: line editing changes the last line, over-long lines are broken.
   */
  write(text: string): void {
    let entries = this.kept.slice();
    for (const piece of this.reader.read(text)) {
      if (piece.kind === 'text') this.writeText(entries, piece.text);
      else if (piece.kind === 'clear') {
        entries = [];
        this.forget();
      } else this.edit(entries, piece);
    }
    this.closeEntry(entries);
    this.drop(entries);
    this.kept = entries;
  }

  /** Adds a heading, a note or an error card on a line of its own. */
  add(entry: NewEntry): void {
    if (entry.kind === 'run') this.tone = 'plain';
    const entries = this.kept.slice();
    this.addTo(entries, entry);
    this.drop(entries);
    this.kept = entries;
  }

  /** Shows the last traceback quietly: the pupil stopped the program, nothing is wrong. */
  quieten(): void {
    const last = this.kept.findLastIndex((entry) => entry.kind === 'text' && entry.tone === 'error');
    if (last < 0) return;
    this.kept = this.kept.map((entry, index) =>
      index === last && entry.kind === 'text' ? { ...entry, tone: 'quiet' as const } : entry,
    );
  }

  clear(): void {
    this.kept = [];
    this.reader.clear();
    this.forget();
  }

  /** All output that is kept, as the console shows it. */
  toText(): string {
    return this.kept.map((entry) => (entry.kind === 'text' ? entry.text : '')).join('');
  }

  private addTo(entries: ConsoleEntry[], entry: NewEntry): void {
    this.closeEntry(entries);
    this.lineStart = true;
    this.lineLength = this.column = 0;
    this.lines += 1;
    entries.push({ ...entry, id: this.nextId++ });
  }

  private forget(): void {
    this.open = null;
    this.lines = this.lineLength = this.column = 0;
    this.cut = false;
    this.lineStart = true;
  }

  private writeText(entries: ConsoleEntry[], text: string): void {
    for (let from = 0; from < text.length;) {
      const newline = text.indexOf('\n', from);
      const until = newline < 0 ? text.length : newline + 1;
      this.writePart(entries, text.slice(from, until));
      from = until;
    }
  }

  /** One line or a part of one. */
  private writePart(entries: ConsoleEntry[], part: string): void {
    if (this.lineStart && part.startsWith(TRACEBACK)) {
      this.tone = 'error';
      this.traceback = '';
    }
    for (let from = this.overwrite(entries, part); from < part.length;) {
      const room = CONSOLE_LIMITS.lineCharacters - this.lineLength;
      const piece = part.slice(from, from + room);
      from += piece.length;
      const ends = piece.endsWith('\n');
      const broken = !ends && piece.length === room;
      this.append(entries, broken ? `${piece}\n` : piece, ends || broken);
    }
    if (this.tone === 'error') this.readTraceback(entries, part);
  }

  /** A traceback ends with the line that names the exception: the first one that is not indented. */
  private readTraceback(entries: ConsoleEntry[], part: string): void {
    this.traceback += part;
    if (!part.endsWith('\n')) return;
    const line = this.traceback.trimEnd().split('\n').at(-1) ?? '';
    if (line.startsWith(TRACEBACK) || line.startsWith(' ')) return;
    this.tone = 'plain';
    const failure = this.traceback.includes(TYPED) ? failureOf(line, this.traceback) : null;
    if (failure !== null)
      this.addTo(entries, { kind: 'error', place: null, report: { failure, source: null, table: this.table() } });
  }

  /** Writes over what stands right of the cursor, as far as that goes; returns how much of `part` is done. */
  private overwrite(entries: ConsoleEntry[], part: string): number {
    const over = part.slice(0, this.lineLength - this.column).replace(/\n$/, '');
    if (over === '') return 0;
    const { column } = this;
    this.changeLine(entries, (line) => line.slice(0, column) + over + line.slice(column + over.length));
    this.column += over.length;
    return over.length;
  }

  private edit(entries: ConsoleEntry[], piece: Exclude<TerminalPiece, { kind: 'text' | 'clear' }>): void {
    switch (piece.kind) {
      case 'move':
        this.column = Math.max(0, Math.min(this.lineLength, this.column + piece.by));
        break;
      case 'return':
        this.column = 0;
        break;
      case 'erase': {
        if (piece.whole) this.column = 0;
        const { column } = this;
        this.changeLine(entries, (line) => line.slice(0, column));
        break;
      }
      default:
        piece satisfies never;
    }
  }

  /** Changes the line being written, which is the end of the last entry. */
  private changeLine(entries: ConsoleEntry[], change: (line: string) => string): void {
    if (this.lineLength === 0) return;
    if (this.open === null) {
      const last = entries.pop();
      if (last?.kind !== 'text') throw new Error('The line being written is not in the last entry.');
      this.open = { ...last };
    }
    const { text } = this.open;
    const from = text.length - this.lineLength;
    const line = change(text.slice(from));
    this.open.text = text.slice(0, from) + line;
    this.lineLength = line.length;
  }

  /** Adds to the entry being written; a full one, or one in another tone, is closed first. */
  private append(entries: ConsoleEntry[], piece: string, endsLine: boolean): void {
    const { tone } = this;
    const starts = this.lineStart ? 1 : 0;
    this.lines += starts;
    this.lineStart = endsLine;
    this.lineLength = endsLine ? 0 : this.lineLength + piece.length;
    this.column = this.lineLength;
    const last = this.open ?? entries.at(-1);
    const fits = last?.kind === 'text' && (starts === 0 || (last.tone === tone && hasRoom(last)));
    if (!fits) this.closeEntry(entries);
    else if (this.open === null) entries.pop(); // taken up again: output in small pieces makes no small entries
    const open = fits
      ? (this.open ?? { ...last })
      : { id: this.nextId++, kind: 'text' as const, tone, text: '', lines: 0 };
    open.text += piece;
    open.lines += starts;
    this.open = open;
  }

  private closeEntry(entries: ConsoleEntry[]): void {
    if (this.open !== null) entries.push(this.open);
    this.open = null;
  }

  private drop(entries: ConsoleEntry[]): void {
    let dropped = 0;
    const isTooMuch = (): boolean =>
      this.lines > CONSOLE_LIMITS.lines || entries.length - dropped > CONSOLE_LIMITS.entries;
    while (isTooMuch() && dropped < entries.length - 1) {
      const entry = entries[dropped];
      this.lines -= entry?.kind === 'text' ? entry.lines : 1;
      dropped += 1;
    }
    if (dropped === 0) return;
    entries.splice(0, dropped);
    this.cut = true;
  }
}

/** The exception of a line typed at the REPL; an interrupt is not an error. */
function failureOf(line: string, traceback: string): Failure | null {
  const [, type = '', message = ''] = /^(\w+)(?:: (.*))?$/.exec(line) ?? [];
  return type === '' || type === 'KeyboardInterrupt' ? null : { type, message, traceback };
}

function hasRoom(entry: TextEntry): boolean {
  return entry.lines < CONSOLE_LIMITS.entryLines && entry.text.length < CONSOLE_LIMITS.entryCharacters;
}

/** A piece of shown text: plain, or the mention of a line of the pupil's files that can be jumped to. */
export interface TextPiece {
  readonly text: string;
  readonly place: ErrorPlace | null;
}

/** Splits a traceback into plain text and mentions of lines in `files`. */
export function withPlaces(text: string, files: readonly string[]): readonly TextPiece[] {
  const pieces: TextPiece[] = [];
  let from = 0;
  for (const match of text.matchAll(/File "([^"\n]+)", line (\d+)/g)) {
    const [mention, file, line] = match;
    if (file === undefined || line === undefined || !files.includes(file)) continue;
    if (match.index > from) pieces.push({ text: text.slice(from, match.index), place: null });
    pieces.push({ text: mention, place: { file, line: Number(line) } });
    from = match.index + mention.length;
  }
  if (from < text.length) pieces.push({ text: text.slice(from), place: null });
  return pieces;
}

/** The innermost place of a traceback that is in one of the pupil's files. */
export function lastPlace(traceback: string, files: readonly string[]): ErrorPlace | null {
  return withPlaces(traceback, files).findLast((piece) => piece.place !== null)?.place ?? null;
}

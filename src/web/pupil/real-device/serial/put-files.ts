import { FILE_BYTES } from '#project/project';

import { devicePython, fingerprint } from './device-python';
import { settle, type Port, type Timer } from './port';
import { PutError, type PutProblem } from './problem';
import { FAREWELL, RawRepl } from './raw-repl';
import { SerialLine } from './serial-line';

/** A file for the device. */
export interface DeviceFile {
  readonly name: string;
  readonly text: string;
}

/** The files to put on the device. */
export interface PutWish {
  /** The program comes last, so that nothing drives before everything is there. */
  readonly files: readonly DeviceFile[];
  /** Firmware modules that the program needs: one from each list. */
  readonly modules: readonly (readonly string[])[];
  /** True if a file with this fingerprint may be replaced without asking. */
  isKnown(fingerprint: string): boolean;
  /**
   * Asks whether these unknown files on the device may be replaced.
   *
   * @param read fetches one of them while the question is open; one at a time
   */
  mayReplace(names: readonly string[], read: (name: string) => Promise<Uint8Array<ArrayBuffer>>): Promise<boolean>;
}

/** The progress of the transfer. */
export interface PutProgress {
  readonly stage: 'greeting' | 'looking' | 'writing' | 'checking' | 'starting';
  /** The file in transfer, if any. */
  readonly file: string | null;
  /** 0 … 1, never less than before. */
  readonly part: number;
}

/** The outcome of the transfer. */
export type PutResult =
  | {
      readonly kind: 'done';
      /** The device's name for itself. */
      readonly machine: string;
      readonly written: readonly string[];
      /** Files that were already there and up to date. */
      readonly same: readonly string[];
      /** False: main.py starts only when the device's reset button is pressed. */
      readonly isStarted: boolean;
      /** The program's output right after its start. */
      readonly said: string;
    }
  | { readonly kind: 'problem'; readonly problem: PutProblem };

/** The services that the transfer needs. */
export interface PutSurroundings {
  readonly timer: Timer;
  readonly signal: AbortSignal;
  readonly onProgress: (progress: PutProgress) => void;
  /** True if the port stays open after a success. */
  readonly staysOpen?: boolean;
}

const PIECE_BYTES = 192; // chosen: at most 770 characters of Python, a hundredth of a micro:bit's memory
const FIRST_WORDS_MS = 1500; // chosen: a program that cannot start says so at once
const SAID_CHARACTERS = 1000;
/** Shares of the whole transfer: before the writing, and after it. */
const BEFORE = 0.12;
const AFTER = 0.06;

/**
 * Puts files on a device that runs MicroPython and starts its main.py. Only what differs is written; other files on the
 * device are left alone. The port is closed at the end, unless it shall stay open.
 *
 * @returns the outcome; never throws a `PutError`
 */
export async function putFiles(port: Port, wish: PutWish, around: PutSurroundings): Promise<PutResult> {
  const transfer = new Transfer(new SerialLine(port, around.timer, around.signal), wish, around);
  let isOver = true;
  try {
    const result = await transfer.run();
    isOver = around.staysOpen !== true;
    return result;
  } catch (error) {
    if (!(error instanceof PutError)) throw error;
    if (error.problem.kind !== 'interrupted') await settle(port.write(FAREWELL), around.timer);
    const { problem } = error;
    return {
      kind: 'problem',
      problem: problem.kind === 'stopped' ? { ...problem, isTouched: transfer.isTouched } : problem,
    };
  } finally {
    if (isOver) await settle(port.close(), around.timer);
  }
}

interface Content extends DeviceFile {
  readonly bytes: Uint8Array;
  readonly fingerprint: string;
}

class Transfer {
  /** True if something on the device has been changed. */
  isTouched = false;
  private readonly repl: RawRepl;
  private readonly files: readonly Content[];
  private sentBytes = 0;
  private totalBytes = 1;
  private part = 0;

  constructor(
    private readonly line: SerialLine,
    private readonly wish: PutWish,
    private readonly around: PutSurroundings,
  ) {
    this.repl = new RawRepl(line);
    const encoder = new TextEncoder();
    this.files = wish.files.map((file) => {
      const bytes = encoder.encode(file.text);
      return { ...file, bytes, fingerprint: fingerprint(bytes) };
    });
  }

  async run(): Promise<PutResult> {
    this.tell('greeting', null, 0);
    await this.repl.enter();
    const machine = (await this.repl.run(devicePython.about)).slice(0, 100);
    await this.checkModules(machine);
    const { changed, present } = await this.look();
    this.isTouched = changed.length > 0;
    // What is replaced makes room first, and main.py is written last: a transfer that breaks off leaves no program that
    // drives with the wrong libraries.
    for (const { name } of changed) if (present.has(name)) await this.repl.run(devicePython.remove(name));
    this.totalBytes = Math.max(1, sumOf(changed));
    for (const [place, file] of changed.entries()) await this.writeChecked(file, changed.slice(place + 1));
    this.tell('starting', null, 1 - AFTER);
    const isStarted = await this.repl.restart();
    if (isStarted) await this.line.pause(FIRST_WORDS_MS);
    this.tell('starting', null, 1);
    return {
      kind: 'done',
      machine,
      written: changed.map(({ name }) => name),
      same: this.files.filter((file) => !changed.includes(file)).map(({ name }) => name),
      isStarted,
      said: isStarted ? textOf(this.line.take()).trim().slice(-SAID_CHARACTERS) : '',
    };
  }

  private async checkModules(machine: string): Promise<void> {
    for (const names of this.wish.modules) {
      if ((await this.repl.run(devicePython.hasModule(names))) === '1') continue;
      throw new PutError({ kind: 'wrong-board', module: names[0] ?? '', machine });
    }
  }

  /**
   * Finds out which files differ, and which of them are on the device in another form; asks before unknown ones are
   * replaced.
   */
  private async look(): Promise<{ readonly changed: readonly Content[]; readonly present: ReadonlySet<string> }> {
    await this.repl.run(devicePython.prepare);
    const changed: Content[] = [];
    const present = new Set<string>();
    const unknown: string[] = [];
    for (const [place, file] of this.files.entries()) {
      this.tell('looking', file.name, (BEFORE * (place + 1)) / (this.files.length + 1));
      const there = await this.repl.run(devicePython.fingerprint(file.name));
      if (there === file.fingerprint) continue;
      changed.push(file);
      if (there === '-') continue;
      present.add(file.name);
      if (!this.wish.isKnown(there)) unknown.push(file.name);
    }
    if (unknown.length > 0 && !(await this.ask(unknown))) throw new PutError({ kind: 'stopped', isTouched: false });
    return { changed, present };
  }

  /** Asks whether files may be replaced; false once the transfer is stopped. */
  private ask(names: readonly string[]): Promise<boolean> {
    const { signal } = this.around;
    if (signal.aborted) return Promise.resolve(false);
    return new Promise((resolve, reject) => {
      signal.addEventListener('abort', () => resolve(false), { once: true });
      const read = (name: string): Promise<Uint8Array<ArrayBuffer>> => {
        const bytes = this.read(name);
        bytes.catch(reject); // unplugging the cable meanwhile ends the whole transfer
        return bytes;
      };
      this.wish.mayReplace(names, read).then(resolve, () => resolve(false));
    });
  }

  private async read(name: string): Promise<Uint8Array<ArrayBuffer>> {
    await this.repl.run(devicePython.openToRead(name));
    const bytes: number[] = [];
    for (;;) {
      const piece = (await this.repl.run(devicePython.read)).match(/[0-9a-f]{2}/g) ?? [];
      if (piece.length === 0 || bytes.length > FILE_BYTES) break;
      for (const digits of piece) bytes.push(parseInt(digits, 16));
    }
    await this.repl.run(devicePython.close);
    return Uint8Array.from(bytes);
  }

  /** Writes a file and reads it back; once more when it is not the same. */
  private async writeChecked(file: Content, later: readonly Content[]): Promise<void> {
    const before = this.sentBytes;
    for (let attempt = 0; attempt < 2; attempt++) {
      this.sentBytes = before;
      await this.write(file, later);
      this.tell('checking', file.name, this.sentPart());
      if ((await this.repl.run(devicePython.fingerprint(file.name))) === file.fingerprint) return;
    }
    throw new PutError({ kind: 'different', file: file.name });
  }

  private async write({ name, bytes }: Content, later: readonly Content[]): Promise<void> {
    let place = 0;
    try {
      await this.repl.run(devicePython.open(name));
      for (; place < bytes.length; place += PIECE_BYTES) {
        const piece = bytes.subarray(place, place + PIECE_BYTES);
        await this.repl.run(devicePython.write(piece));
        this.sentBytes += piece.length;
        this.tell('writing', name, this.sentPart());
      }
      await this.repl.run(devicePython.close);
    } catch (error) {
      if (!isFull(error)) throw error;
      const overBytes = bytes.length - place + sumOf(later);
      throw new PutError({ kind: 'full', file: name, overBytes, others: await this.others() });
    }
  }

  /** The other files on the device. */
  private async others(): Promise<readonly string[]> {
    const own = new Set(this.files.map(({ name }) => name));
    const names = textOf(await this.repl.run(devicePython.list)).split(/\r?\n/);
    return names.map((name) => name.trim()).filter((name) => name !== '' && !own.has(name));
  }

  private sentPart(): number {
    return BEFORE + (1 - BEFORE - AFTER) * Math.min(1, this.sentBytes / this.totalBytes);
  }

  private tell(stage: PutProgress['stage'], file: string | null, part: number): void {
    this.part = Math.max(this.part, part);
    this.around.onProgress({ stage, file, part: this.part });
  }
}

const sumOf = (files: readonly Content[]): number => files.reduce((sum, { bytes }) => sum + bytes.length, 0);

/** ENOSPC as the devices write it: `OSError: 28`, `OSError: [Errno 28] ENOSPC`. */
const isFull = (error: unknown): boolean =>
  error instanceof PutError && error.problem.kind === 'exception' && /OSError:.*\b28\b|ENOSPC/.test(error.problem.text);

/** The text of these bytes; bytes that are not text show as replacement characters. */
const textOf = (bytes: string): string =>
  new TextDecoder().decode(Uint8Array.from(bytes, (sign) => sign.charCodeAt(0)));

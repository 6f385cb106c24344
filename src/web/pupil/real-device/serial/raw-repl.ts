import { PutError } from './problem';
import type { SerialLine } from './serial-line';

const CTRL_A = '\x01';
const CTRL_B = '\x02';
const CTRL_C = '\x03';
const CTRL_D = '\x04';
/** The banner that MicroPython's shared/runtime/pyexec.c prints when raw mode begins. */
const RAW_BANNER = 'raw REPL; CTRL-B to exit\r\n>';

// chosen: a micro:bit easily meets these times, and waiting them out in vain does no harm
const ROUNDS = 5;
const INTERRUPT_MS = 150;
const BANNER_LIMIT_MS = 900;
const REBOOT_LIMIT_MS = 4000;
const ACCEPT_LIMIT_MS = 3000;
const RUN_LIMIT_MS = 10_000;
const PROMPT_LIMIT_MS = 2000;
const EXCEPTION_CHARACTERS = 2000;

/** MicroPython's raw mode, made for tools: no prompt, no echo, no automatic indentation. */
export class RawRepl {
  constructor(private readonly line: SerialLine) {}

  /**
   * Stops the running program and enters raw mode with an empty memory.
   *
   * @throws PutError `silent` or `no-prompt` if no MicroPython listens; those of the line
   */
  async enter(): Promise<void> {
    // More than one round: the first Ctrl-C may only skip the text of an error that scrolls over the display.
    for (let round = 0; !(await this.askForRaw()); round++) {
      if (round + 1 < ROUNDS) continue;
      throw new PutError({ kind: this.line.heardBytes === 0 ? 'silent' : 'no-prompt' });
    }
    // The stopped program's variables would take up memory. In raw mode, main.py does not start after a soft reboot.
    await this.line.send(CTRL_D);
    if ((await this.line.until(RAW_BANNER, REBOOT_LIMIT_MS)) === null) throw new PutError({ kind: 'no-prompt' });
  }

  /**
   * Runs a piece of Python.
   *
   * @param code ASCII; the names it defines remain for the next piece
   * @returns what it printed, trimmed
   * @throws PutError `exception` with the device's words, `stuck`, `garbled`; those of the line
   */
  async run(code: string): Promise<string> {
    await this.line.send(code + CTRL_D);
    const before = await this.line.until('OK', ACCEPT_LIMIT_MS);
    if (before === null) throw new PutError({ kind: 'stuck' });
    if (before !== '') throw new PutError({ kind: 'garbled' });
    const printed = await this.end(CTRL_D, RUN_LIMIT_MS);
    const failure = await this.end(CTRL_D, PROMPT_LIMIT_MS);
    if ((await this.end('>', PROMPT_LIMIT_MS)) !== '') throw new PutError({ kind: 'garbled' });
    if (failure === '') return printed.trim();
    throw new PutError({ kind: 'exception', text: failure.trim().slice(-EXCEPTION_CHARACTERS) });
  }

  /**
   * Leaves raw mode with a soft reboot, so that main.py starts.
   *
   * @returns false if the device did not announce the reboot
   */
  async restart(): Promise<boolean> {
    await this.line.send(CTRL_B);
    if ((await this.line.until('>>> ', PROMPT_LIMIT_MS)) === null) return false;
    await this.line.send(CTRL_D);
    return (await this.line.until('soft reboot', REBOOT_LIMIT_MS)) !== null;
  }

  private async askForRaw(): Promise<boolean> {
    await this.line.send(`\r${CTRL_C}${CTRL_C}`);
    await this.line.pause(INTERRUPT_MS);
    this.line.forget();
    await this.line.send(CTRL_A);
    return (await this.line.until(RAW_BANNER, BANNER_LIMIT_MS)) !== null;
  }

  private async end(mark: string, limitMs: number): Promise<string> {
    const before = await this.line.until(mark, limitMs);
    if (before === null) throw new PutError({ kind: 'stuck' });
    return before;
  }
}

/** Discards a half-sent piece and leaves raw mode: for a device abandoned in mid-transfer. */
export const FAREWELL = Uint8Array.from(`\r${CTRL_C}${CTRL_C}${CTRL_B}`, (sign) => sign.charCodeAt(0));

import type { Clock } from '#core/clock';
import type { Inspected } from '../debug/inspected';
import { ConsolePort } from './console-port';
import type { Hold } from './engine';
import { fileHint, Files } from './files';
import { Repl } from './repl';
import { Report, type VmEnd } from './report';
import { Session } from './session';
import type { VmSetup } from './vm-setup';

export type { VmEnd, VmException } from './report';
export type { Observer } from './observed';
export type { VmSetup } from './vm-setup';

/** A microcomputer's MicroPython: one program, run piece by piece under the run's clock, and the REPL after its end. */
export interface Vm {
  /**
   * Runs until the clock reaches the limit (µs; a current call of the device may pass it), or returns at once when the
   * program ends. If resumed after that, time goes on, and the REPL answers input.
   */
  resume(limitUs: number): void;
  /** How main.py ended; `null` while it runs, also when the REPL has rebooted and it runs again. */
  readonly ended: VmEnd | null;
  /** True once the REPL has greeted: it then receives the input. */
  readonly isInRepl: boolean;
  /** True while main.py waits in `input()`. */
  readonly awaitsInput: boolean;
  /** Raises KeyboardInterrupt in the program; in the REPL it is Ctrl-C. */
  interrupt(): void;
  /** The same, but from now on the traceback of a KeyboardInterrupt is not shown; that of any other exception is. */
  stop(): void;
  /** Text that a person types on the serial line. Ctrl-C (\x03) in it interrupts, unless the program switched that off. */
  feed(text: string): void;
  /**
   * The state that a debugger reads (`../debug`) while the program is paused; another object after a reset of the
   * board.
   */
  readonly inspected: Inspected;
  /**
   * The condition on which the program is paused before its time is over; a watch takes effect with the next
   * `resume`.
   */
  readonly hold: Hold;
  /** Free bytes of the program's heap, as `gc.mem_free()` gives them; after the program's end, the bytes it left. */
  heapFree(): number;
  /** Gives its memory to the next VM. Call nothing else afterwards. */
  dispose(): void;
}

/** From power-up to the first line of main.py. Chosen: a micro:bit V2 takes about half a second. */
const RESET_US = 500_000;
const CTRL_C = '\x03';
/** micropython-microbit-v2 main.c. */
const REBOOT = new TextEncoder().encode('MPY: soft reboot\r\n');

/** Makes a VM. The program begins with the first `resume`. */
export function createVm(setup: VmSetup): Vm {
  const { board, clock } = setup;
  const files = new Files(setup.files);
  const report = reportOn(setup, files);
  const port = new ConsolePort((bytes) => report.write(bytes));
  const repl = new Repl(port, board.firmware.banner, setup.repl === 'at-once');
  const hold: Hold = { watch: null, isHeld: false };
  const start = (startUs: number): Session => new Session(setup, { files, port, report, repl, hold, startUs });
  let [session, isOver] = [start(clock.nowUs), false];
  const restart = (kind: 'reset' | 'reboot'): void => {
    // Like the device: files stay, everything else starts again.
    if (kind === 'reboot') report.write(REBOOT);
    session.dispose();
    board.reset();
    port.watchForInterrupt();
    const startUs = kind === 'reset' ? resetAt(port, clock) : session.startUs;
    report.restart();
    session = start(startUs);
  };
  const interrupt = (): void => {
    if (port.interruptByte !== null || report.ended === null) session.interrupt();
    else if (!repl.isAsleep) port.feed(CTRL_C);
  };
  return {
    resume: (limitUs) => {
      // After a panic the board answers nothing, and time goes on.
      if (isOver && limitUs > clock.nowUs && limitUs < Infinity) clock.advanceTo(limitUs);
      const before = report.ended;
      while (!isOver && clock.nowUs < limitUs) {
        const state = session.run(limitUs);
        isOver = state === 'ended';
        if (state === 'reset' || state === 'reboot') restart(state);
        if (state === 'suspended' || (report.ended !== null && report.ended !== before)) return;
      }
    },
    get ended() {
      return report.ended;
    },
    get isInRepl() {
      return report.ended !== null && !isOver && !repl.isAsleep;
    },
    get awaitsInput() {
      return report.ended === null && port.awaitsLine;
    },
    interrupt,
    stop: () => {
      report.hideInterrupt();
      interrupt();
    },
    feed: (text) => port.feed(text),
    get inspected() {
      return session.inspected;
    },
    hold,
    heapFree: () => session.heapFree,
    dispose: () => session.dispose(),
  };
}

/** Only a reset restarts the device's clock as well. @returns when it begins */
function resetAt(port: ConsolePort, clock: Clock): number {
  port.reset();
  clock.advanceTo(clock.nowUs + RESET_US);
  return clock.nowUs;
}

function reportOn(setup: VmSetup, files: Files): Report {
  const read = (name: string): string => new TextDecoder().decode(files.find(name)?.bytes);
  return new Report((text) => setup.write(text), read, fileHint(setup.files));
}

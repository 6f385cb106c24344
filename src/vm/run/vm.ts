import { ConsolePort } from './console-port';
import { Files } from './files';
import { Report, type VmEnd } from './report';
import { Session } from './session';
import { showError } from './show-error';
import type { VmSetup } from './vm-setup';

export type { VmEnd, VmException } from './report';
export type { VmSetup } from './vm-setup';

/** A microcomputer's MicroPython: one program, run piece by piece under the run's clock. */
export interface Vm {
  /** Runs until the clock reaches the limit (µs; a call of the device that is under way may pass it) or the program ends. */
  resume(limitUs: number): void;
  /** How the program ended, or `null` while it runs. */
  readonly ended: VmEnd | null;
  /** Raises KeyboardInterrupt in the program. */
  interrupt(): void;
  /** Text that a person types on the serial line. */
  feed(text: string): void;
  /** Free bytes of the program's heap, as `gc.mem_free()` gives them; after the program's end those it left. */
  heapFree(): number;
}

/** From power-up to the first line of main.py. Chosen: a micro:bit V2 takes about half a second. */
const RESET_US = 500_000;

/** Makes a VM. The program begins with the first `resume`. */
export function createVm(setup: VmSetup): Vm {
  const files = new Files(setup.files);
  const report = new Report((text) => setup.write(text), setup.files['main.py']?.length ?? 0);
  const port = new ConsolePort((bytes) => report.write(bytes));
  let session = new Session(setup, { files, port, report });
  const runOn = (limitUs: number): void => {
    while (setup.clock.nowUs < limitUs && session.run(limitUs) === 'reset') {
      // Like the device: files stay, everything else begins anew.
      setup.clock.advanceTo(setup.clock.nowUs + RESET_US);
      session = new Session(setup, { files, port, report });
    }
  };
  const showFailure = (): void => {
    const { ended } = report;
    if (ended?.kind === 'exception' && ended.exception) showError(setup.board, ended.exception);
  };
  return {
    resume: (limitUs) => {
      if (report.ended !== null) return;
      runOn(limitUs);
      showFailure();
    },
    get ended() {
      return report.ended;
    },
    interrupt: () => session.interrupt(),
    feed: (text) => port.feed(text),
    heapFree: () => session.heapFree,
  };
}

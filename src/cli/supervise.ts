import type { Report } from './report';
import { createDeviceLines } from './device-lines';
import { createConsoleReader, createSharedConsole, type SharedConsole } from './shared-console';
import type { Terminal } from './terminal';
import { threadOf } from './threads/thread';
import { RadioReport } from './with-radio';
import { BEAT, INTERRUPT, type ReplayOutcome, type WorkerMessage, type WorkerTask } from './worker-messages';

/** The result of a run. */
export type Outcome =
  /** With the output of each device. */
  | {
      readonly type: 'ran';
      readonly report: Report;
      readonly consoles: readonly string[];
      /** Result of a repetition that has reached its end. */
      readonly replay: ReplayOutcome | null;
    }
  | { readonly type: 'refused'; readonly problem: string }
  | { readonly type: 'broken'; readonly problem: string };

/** After this time without a heartbeat (wall time), the run is stuck inside one call that never ends. */
export const STUCK_MS = 10_000;

/** Time for the `finally` of an interrupted program, in ms of wall time. */
const FAREWELL_MS = 500;

const LOOK_MS = 100;

/** Interval of checks for output. Chosen: looks immediate to a reader. */
const DRAIN_MS = 20;

/** Approximate limit for output in the report; later output was only shown. Chosen: ten minutes of printing. */
const MAX_CONSOLE_CHARACTERS = 16_000_000;

/** The known facts about a run that was ended before it could report. */
export const nothingYet: Report = {
  ended: 'stuck',
  exception: null,
  simulatedMs: 0,
  wallMs: 0,
  realTimeFactor: 0,
  robot: null,
  display: '00000:00000:00000:00000:00000',
  verdict: null,
  heapFree: 0,
  traceHash: '',
  radio: [],
  radioSent: 0,
  lights: [],
  devices: [],
};

/** Runs the task in a thread of its own, passes its output on, and ends it if it is stuck or Ctrl-C is pressed. */
export function supervise(task: Omit<WorkerTask, 'shared' | 'console'>, terminal: Terminal): Promise<Outcome> {
  const shared = new Int32Array(new SharedArrayBuffer(2 * Int32Array.BYTES_PER_ELEMENT));
  const names = task.setup.devices.map(({ name }) => name);
  const output = passOn(createSharedConsole(), names, terminal);
  const worker = threadOf('worker');
  worker.postMessage({ ...task, shared, console: output.shared } satisfies WorkerTask);
  let latest = nothingYet;
  const radio = new RadioReport();
  return new Promise((resolve) => {
    const ran = (report: Report, replay: ReplayOutcome | null = null): void =>
      finish(() => ({ type: 'ran', report: radio.in(report), consoles: output.all(), replay }));
    const watch = watchBeat(shared, () => ran({ ...latest, ended: 'stuck' }));
    const interruption = onInterrupt(shared, () => ran({ ...latest, ended: 'stopped' }));
    function finish(outcome: () => Outcome): void {
      watch.stop();
      interruption.stop();
      output.stop();
      terminal.clearProgress();
      void worker.terminate();
      resolve(outcome());
    }
    worker.on('message', (message: WorkerMessage) => {
      if ('radio' in message) radio.add(message.radio);
      switch (message.type) {
        case 'progress':
          latest = message.report;
          return terminal.progress(latest.simulatedMs, latest.realTimeFactor);
        case 'done':
          return ran(
            interruption.happened() ? { ...message.report, ended: 'stopped' } : message.report,
            message.replay,
          );
        case 'refused':
        case 'broken':
          return finish(() => message);
        default:
          message satisfies never;
      }
    });
    worker.on('error', (error: Error) => finish(() => ({ type: 'broken', problem: error.stack ?? error.message })));
  });
}

/** The programs' output in transit. */
interface Output {
  readonly shared: SharedConsole;
  stop(): void;
  /** All output so far, by device. */
  all(): readonly string[];
}

/** Passes the programs' output on to the terminal, every `DRAIN_MS` and at the end, and stores it for the report. */
function passOn(shared: SharedConsole, names: readonly string[], terminal: Terminal): Output {
  const read = createConsoleReader(shared);
  const all = names.map(() => '');
  const lines = names.length > 1 ? createDeviceLines(names, (text) => terminal.program(text)) : null;
  const drain = (): void => {
    for (const { device, text } of read()) {
      const before = all[device] ?? '';
      if (before.length < MAX_CONSOLE_CHARACTERS) all[device] = before + text;
      if (lines === null) terminal.program(text);
      else lines.add(device, text);
    }
  };
  const timer = setInterval(drain, DRAIN_MS);
  return {
    shared,
    all: () => all,
    stop() {
      clearInterval(timer);
      drain();
      lines?.end();
    },
  };
}

/** Calls `stuck` when the beat has not changed for `STUCK_MS`. */
function watchBeat(shared: Int32Array, stuck: () => void): { stop(): void } {
  let beat = 0;
  let changedMs = performance.now();
  const timer = setInterval(() => {
    const now = Atomics.load(shared, BEAT);
    if (now !== beat) {
      beat = now;
      changedMs = performance.now();
    } else if (performance.now() - changedMs > STUCK_MS) {
      stuck();
    }
  }, LOOK_MS);
  return { stop: () => clearInterval(timer) };
}

/** The first Ctrl-C interrupts the program; after `FAREWELL_MS` or on the second one, `end` is called. */
function onInterrupt(shared: Int32Array, end: () => void): { stop(): void; happened(): boolean } {
  let timer: NodeJS.Timeout | null = null;
  const interrupt = (): void => {
    if (timer) return end();
    Atomics.store(shared, INTERRUPT, 1);
    timer = setTimeout(end, FAREWELL_MS);
  };
  process.on('SIGINT', interrupt);
  process.on('SIGTERM', interrupt);
  return {
    happened: () => timer !== null,
    stop() {
      if (timer) clearTimeout(timer);
      process.off('SIGINT', interrupt);
      process.off('SIGTERM', interrupt);
    },
  };
}

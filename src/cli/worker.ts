/** The thread of a headless run: nothing here waits, and only the run's end or `terminate` stops it. */
import { parentPort } from 'node:worker_threads';
import type { LogEvent } from '#board/data-log';
import { runningTo, SLICE_US } from '#lab/run-end';
import { csvOf, emptyLog, withLogEvents } from '#simulation/log-table';
import type { RunOutlets } from '#simulation/outlets';
import { PHYSICS } from '#simulation/physics-version';
import { fitRun } from '#simulation/run-problem';
import { Simulation } from '#simulation/simulation';
import { tapeToText } from '#tape/file';
import { momentOf, type Moment } from '#tape/moment';
import { OutputHashes, resultOf } from '#tape/result';
import { atLine } from '#vm/debug/stops';
import { version } from '../../package.json';
import type { StopAsked } from './replay/replay-arguments';
import { readFirmware } from './firmware';
import { RadioKeeper, type RadioNews } from './radio-report';
import { reportOf, type Report } from './report';
import { reasonOf } from './reason-of';
import { createConsoleWriter } from './shared-console';
import { traceColumns, traceHeader, traceLine, type TraceColumns } from './trace-csv';
import { BEAT, INTERRUPT, type WorkerMessage, type WorkerTask } from './worker-messages';
import { emptyOutput, writeAll } from './write-output';

/** Wall time between two messages. Chosen: looks immediate to a reader, costs the run less than 1 %. */
const MESSAGE_MS = 50;

const post = (message: WorkerMessage): void => parentPort?.postMessage(message);

/** Writes the rows since the last call; the first call writes the names of the columns. */
function createTraceWriter(simulation: Simulation, file: number | null, devices: number): () => void {
  let columns: TraceColumns | null = null;
  return () => {
    if (file === null) return;
    const rows = simulation.takeTrace();
    if (columns === null) {
      columns = traceColumns(rows, devices);
      emptyOutput(file);
      writeAll(file, `${traceHeader(columns)}\n`);
    }
    const shown = columns;
    writeAll(file, rows.map((row) => `${traceLine(row, shown)}\n`).join(''));
  };
}

/** Collects the programs' packets and the first one's log rows; their text goes straight to the terminal. */
function createNews(task: WorkerTask): {
  readonly outlets: RunOutlets;
  /** Packets of each device since the last call. */
  readonly takeRadio: () => readonly RadioNews[];
  readonly log: LogEvent[];
  readonly output: OutputHashes;
} {
  const output = new OutputHashes(task.setup.devices.length);
  const isHashed = task.tapeFile !== null || task.replay !== null;
  const show = createConsoleWriter(task.console);
  const radio = task.setup.devices.map(() => new RadioKeeper());
  const log: LogEvent[] = [];
  const outlets: RunOutlets = {
    print: (text, device) => {
      if (isHashed) output.add(text, device);
      show(text, device);
    },
    radio: (packet, device) => radio[device]?.add(packet),
    ...(task.logFile === null
      ? {}
      : {
          log: (event, device) => {
            if (device === 0) log.push(event);
          },
        }),
  };
  return { outlets, takeRadio: () => radio.map((one) => one.take()), log, output };
}

function writeLog(file: number, events: readonly LogEvent[]): void {
  emptyOutput(file);
  writeAll(file, csvOf(withLogEvents(emptyLog, events)));
}

function writeTape(
  file: number,
  { setup, untilUs, untilProgramEnds }: WorkerTask,
  run: Simulation,
  output: OutputHashes,
): void {
  emptyOutput(file);
  const inputs = run.inputLog;
  // An interrupted run has not reached its time limit.
  const until = {
    untilUs: run.hasEnded && untilProgramEnds ? untilUs : Math.min(untilUs, run.nowUs),
    untilProgramEnds,
  };
  writeAll(
    file,
    tapeToText({
      madeBy: version,
      physics: PHYSICS,
      setup: { ...setup, inputs },
      ...until,
      result: resultOf(run, output),
    }),
  );
}

/** Lets a repetition continue to its stop. @returns null: the line is reached less often than that */
function runToStop(
  simulation: Simulation,
  { shared, untilUs }: WorkerTask,
  asked: StopAsked,
  device: number,
): Moment | null {
  const isLine = 'line' in asked;
  if (isLine) simulation.watch(atLine(asked, asked.hit), device);
  const endUs = isLine ? untilUs : asked.timeUs;
  while (simulation.nowUs < endUs && simulation.heldBy === null && !(isLine && simulation.hasEnded)) {
    simulation.advanceTo(Math.min(endUs, simulation.nowUs + SLICE_US));
    Atomics.add(shared, BEAT, 1);
  }
  if (isLine) return simulation.heldBy === null ? null : momentOf(simulation, device);
  // Another device's clock may be a little before that of the world.
  return { ...momentOf(simulation, device), timeMs: simulation.nowUs / 1000 };
}

function runToEnd(simulation: Simulation, task: WorkerTask, takeRadio: () => readonly RadioNews[]): Report {
  const { shared } = task;
  const writeTrace = createTraceWriter(simulation, task.traceFile, task.setup.devices.length);
  const startMs = performance.now();
  let toldMs = startMs;
  let isInterrupted = false;
  const { isOver, advance } = runningTo(simulation, task);
  // A program that is stuck in its very first call is reported in its state at that moment.
  post({ type: 'progress', report: reportOf(simulation, 0), radio: takeRadio() });
  while (!isOver(isInterrupted)) {
    advance();
    Atomics.add(shared, BEAT, 1);
    if (!isInterrupted && Atomics.load(shared, INTERRUPT) === 1) {
      isInterrupted = true;
      simulation.interrupt();
    }
    const nowMs = performance.now();
    if (nowMs - toldMs < MESSAGE_MS) continue;
    toldMs = nowMs;
    writeTrace();
    post({ type: 'progress', report: reportOf(simulation, nowMs - startMs), radio: takeRadio() });
  }
  const wallMs = performance.now() - startMs;
  writeTrace();
  return reportOf(simulation, wallMs);
}

async function work(task: WorkerTask): Promise<void> {
  const checked = fitRun(task.setup, task.replay === null);
  if ('problem' in checked) {
    post({ type: 'refused', problem: checked.problem });
    return;
  }
  const firmware = await WebAssembly.compile(readFirmware());
  Atomics.add(task.shared, BEAT, 1);
  const news = createNews(task);
  const simulation = await Simulation.create(task.setup, firmware, news.outlets);
  Atomics.add(task.shared, BEAT, 1);
  const { replay } = task;
  const stop = replay?.stop ?? null;
  const moment = stop && runToStop(simulation, task, stop, replay?.device ?? 0);
  const report = stop ? reportOf(simulation, 0) : runToEnd(simulation, task, news.takeRadio);
  if (task.logFile !== null) writeLog(task.logFile, news.log);
  if (task.tapeFile !== null) writeTape(task.tapeFile, task, simulation, news.output);
  const repeated = replay && { result: resultOf(simulation, news.output), moment };
  post({ type: 'done', report, radio: news.takeRadio(), replay: repeated });
}

/** True for a full disk and the like, which are not our mistake. */
const isFailedWrite = (error: unknown): boolean =>
  error instanceof Error && 'syscall' in error && ['write', 'ftruncate'].includes(String(error.syscall));

parentPort?.once('message', (task: WorkerTask) => {
  work(task).catch((error: unknown) => {
    if (isFailedWrite(error)) post({ type: 'refused', problem: `A result cannot be written: ${reasonOf(error)}` });
    else post({ type: 'broken', problem: error instanceof Error ? (error.stack ?? error.message) : String(error) });
  });
});

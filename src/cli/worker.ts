/** The thread in which a headless run happens: nothing here waits, and nothing stops it but the run's end or `terminate`. */
import { existsSync, ftruncateSync, readFileSync, writeSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { parentPort, workerData } from 'node:worker_threads';
import { checkRun } from '#simulation/run-problem';
import { Simulation } from '#simulation/simulation';
import { reportOf } from './report';
import { createConsoleWriter } from './shared-console';
import { traceHeader, traceLine } from './trace-csv';
import { BEAT, INTERRUPT, type WorkerMessage, type WorkerTask } from './worker-messages';

/** Simulated time between two looks at the outside. Chosen: some ms of wall time, yet few suspensions of the program. */
const SLICE_US = 100_000;

/** Wall time between two messages. Chosen: looks immediate to a reader, costs the run less than 1 %. */
const MESSAGE_MS = 50;

const post = (message: WorkerMessage): void => parentPort?.postMessage(message);

function readFirmware(): Uint8Array<ArrayBuffer> {
  const places = ['./vm.wasm', '../../.cache/vm/vm.wasm'].map((place) =>
    fileURLToPath(new URL(place, import.meta.url)),
  );
  const place = places.find((candidate) => existsSync(candidate));
  if (place === undefined) throw new Error(`The VM is missing (${places.join(', ')}). Run: npm run setup`);
  return new Uint8Array(readFileSync(place));
}

/** Writes the rows that came since the last call; the first call writes the names of the columns. */
function createTraceWriter(simulation: Simulation, file: number | null): () => void {
  let written = -1;
  return () => {
    if (file === null) return;
    if (written < 0) {
      ftruncateSync(file);
      writeSync(file, `${traceHeader(simulation.trace[0])}\n`);
    }
    const rows = simulation.trace.slice(Math.max(written, 0));
    writeSync(file, rows.map((row) => `${traceLine(row)}\n`).join(''));
    written = simulation.trace.length;
  };
}

function runToEnd(simulation: Simulation, task: WorkerTask): void {
  const { shared, untilUs, untilProgramEnds } = task;
  const writeTrace = createTraceWriter(simulation, task.traceFile);
  const startMs = performance.now();
  let toldMs = startMs;
  let isInterrupted = false;
  const isOver = (): boolean =>
    simulation.nowUs >= untilUs || (simulation.ended !== null && (untilProgramEnds || isInterrupted));
  while (!isOver()) {
    const nextUs = Math.min(untilUs, simulation.nowUs + SLICE_US);
    if (untilProgramEnds) simulation.advanceProgramTo(nextUs);
    else simulation.advanceTo(nextUs);
    Atomics.add(shared, BEAT, 1);
    if (!isInterrupted && Atomics.load(shared, INTERRUPT) === 1) {
      isInterrupted = true;
      simulation.interrupt();
    }
    const nowMs = performance.now();
    if (nowMs - toldMs < MESSAGE_MS) continue;
    toldMs = nowMs;
    writeTrace();
    post({ type: 'progress', report: reportOf(simulation, nowMs - startMs) });
  }
  const wallMs = performance.now() - startMs;
  writeTrace();
  post({ type: 'done', report: reportOf(simulation, wallMs) });
}

async function work(task: WorkerTask): Promise<void> {
  const checked = checkRun(task.setup);
  if ('problem' in checked) {
    post({ type: 'refused', problem: checked.problem });
    return;
  }
  const firmware = await WebAssembly.compile(readFirmware());
  Atomics.add(task.shared, BEAT, 1);
  const simulation = await Simulation.create(task.setup, firmware, createConsoleWriter(task.console));
  Atomics.add(task.shared, BEAT, 1);
  runToEnd(simulation, task);
}

await work(workerData as WorkerTask).catch((error: unknown) => {
  post({ type: 'broken', problem: error instanceof Error ? (error.stack ?? error.message) : String(error) });
});

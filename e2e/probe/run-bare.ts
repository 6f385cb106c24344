import { ranTo } from '#lab/ran-to';
import { readSweep, valuesOf } from '#lab/sweep';
import { sweepJson, type SweepRun } from '#lab/sweep-texts';
import { withValues } from '#lab/what';
import { Simulation } from '#simulation/simulation';
import type { ProbeResult, ProbeTask, SweepTask } from './messages';

/** One run without the app: in the worker of an engine, or in Node to compare with. */
export async function runBare({ firmware, setup, untilMs }: ProbeTask): Promise<ProbeResult> {
  const told: string[] = [];
  const tell = (kind: string) => (what: object, device: number) => {
    told.push(`${kind} ${device} ${JSON.stringify(what)}`);
  };
  const outlets = { sound: tell('sound'), radio: tell('radio'), log: tell('log') };
  const simulation = await Simulation.create(setup, firmware, outlets);
  simulation.advanceTo(untilMs * 1000);
  const { traceHash, nowUs } = simulation;
  const console = setup.devices.map((_, device) => simulation.takeConsole(device)).join('');
  const heapFree = setup.devices.map((_, device) => simulation.heapFree(device));
  const result = { traceHash, console, timeUs: nowUs, heapFree, told };
  simulation.dispose();
  return result;
}

/** The longest run of a sweep here, in simulated µs. */
const MOST_US = 10_000_000;

/** The table of a sweep without the app, as one line of JSON: in the worker of an engine, or in Node to compare with. */
export async function sweepBare({ firmware, setup, vary }: SweepTask): Promise<string> {
  const base = { setup, usedSeed: setup.seed };
  const sweep = readSweep(vary, base);
  if ('problem' in sweep) throw new Error(sweep.problem);
  const runs: SweepRun[] = [];
  const end = { untilUs: MOST_US, untilProgramEnds: false, untilVerdict: true };
  for (let place = 0; place < sweep.count; place++) {
    const values = valuesOf(sweep, place);
    const made = await ranTo(withValues(base, sweep.varied, values), end, { firmware, beat: () => undefined });
    runs.push({ values, ...made.outcome });
  }
  return sweepJson({ varied: sweep.varied.map(({ name }) => name), runs });
}

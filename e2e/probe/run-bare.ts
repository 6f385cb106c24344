import { Simulation } from '#simulation/simulation';
import type { ProbeResult, ProbeTask } from './messages';

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

import { Simulation } from '#simulation/simulation';
import type { ProbeAnswer, ProbeResult, ProbeTask } from './messages';

async function run({ firmware, setup, untilMs }: ProbeTask): Promise<ProbeResult> {
  const simulation = await Simulation.create(setup, firmware);
  simulation.advanceTo(untilMs * 1000);
  const { traceHash, nowUs } = simulation;
  const result = { traceHash, console: simulation.takeConsole(), timeUs: nowUs, heapFree: simulation.heapFree() };
  simulation.dispose();
  return result;
}

addEventListener('message', (event: MessageEvent<ProbeTask>) => {
  const answer = (message: ProbeAnswer): void => {
    // The worker's own postMessage; the compiler takes it for a window's.
    (postMessage as (message: ProbeAnswer) => void)(message);
  };
  run(event.data).then(
    (result) => answer({ result }),
    (error: unknown) => answer({ problem: error instanceof Error ? (error.stack ?? error.message) : String(error) }),
  );
});

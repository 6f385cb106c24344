import type { Simulation } from '#simulation/simulation';

/**
 * Time for which everything must be still after the program's end until a run is over. Chosen: a robot that rolls out
 * has stopped.
 */
export const STILL_US = 500_000;

/**
 * Returns a function that is true if nothing more can happen: the programs have ended, no alarm is set, and nothing has
 * moved for that long.
 */
export function stillness(simulation: Simulation, longUs = STILL_US): () => boolean {
  const canMove = simulation.scene.objects.some(({ type }) => type === 'mover');
  let [place, sinceUs] = ['', 0];
  return () => {
    if (canMove || !simulation.hasEnded || !simulation.isIdle) return false;
    const { robot, others, blocks } = simulation.snapshot();
    const now = JSON.stringify([robot?.pose, others.map((other) => other.robot?.pose), blocks]);
    if (now !== place) [place, sinceUs] = [now, simulation.nowUs];
    return simulation.nowUs - sinceUs >= longUs;
  };
}

import { check, type Checker } from './check';
import type { HandIn } from './hand-in/hand-in';
import type { Onlooker } from './run/run-world';
import type { ClassTask } from './task/task';

/** Simulated time of a rehearsal, in µs. Chosen: 15 steps of the world; longer ones gain nothing that can be measured. */
const REHEARSED_US = 60_000;

/**
 * Runs the beginning of a hand-in for nothing, before a thread checks its first one. An engine that has seen a single run takes
 * the functions of that run for the only ones there are: the machine code that it makes is thrown away in the second run, and
 * made again (decision 0102). No result depends on it.
 */
export async function rehearse(
  task: ClassTask,
  handIn: HandIn,
  { firmware }: Pick<Checker, 'firmware'>,
): Promise<void> {
  const [world] = task.worlds;
  if (world !== undefined) await check({ ...task, worlds: [world] }, handIn, { firmware, onlooker: untilRehearsed });
}

function untilRehearsed(): Onlooker {
  let nowUs = 0;
  return {
    look: (run) => void ({ nowUs } = run),
    get hasEnough() {
      return nowUs >= REHEARSED_US;
    },
  };
}

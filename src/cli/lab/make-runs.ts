import { Asker, inLanes, START_MS } from '#check/lane';
import { stuckOutcome } from '#lab/outcome';
import type { RunAnswer, RunRequest } from '#lab/run-request';
import { hasTask } from '#simulation/task/task-brief';
import { readFirmware } from '../firmware';
import { every, threads } from '../threads/threads';
import type { RunnerData } from './lab-messages';

type Problem = { readonly problem: string };

/** The result of a run that has run. */
export type RunMade = Exclude<RunAnswer, { readonly refused: string }>;

/** A run, and something that the caller knows it by. */
export interface Wanted<T> {
  readonly is: T;
  readonly request: RunRequest;
}

type Lane = Asker<RunRequest, RunAnswer>;

/** Makes runs side by side, in threads that live until it is stopped. What they come to does not depend on their number. */
export interface RunMaker {
  /**
   * @param made called with each result, in the order in which they end
   * @returns `null`, or why a run was refused: then the others are given up
   */
  make<T>(
    runs: Iterable<Wanted<T>>,
    made: (is: T, result: RunMade) => void,
  ): Promise<{ readonly is: T; readonly problem: string } | null>;
  /** Ends the threads. */
  stop(): void;
}

/** @param jobs the most threads; each starts with its first run */
export async function runMaker(jobs: number): Promise<RunMaker> {
  const firmware = await WebAssembly.compile(readFirmware());
  const start = threads<RunRequest, RunAnswer>('lab-worker', (): Omit<RunnerData, 'shared'> => ({ firmware }));
  // A run has as long as it takes: only one without a sign of life is given up.
  const lanes = Array.from({ length: jobs }, (): Lane => new Asker(start, every, Infinity, START_MS));
  return {
    make: (runs, made) => makeRuns(runs, lanes, made),
    stop: () => lanes.forEach((lane) => lane.stop()),
  };
}

async function makeRuns<T>(
  runs: Iterable<Wanted<T>>,
  lanes: readonly Lane[],
  made: (is: T, result: RunMade) => void,
): Promise<{ readonly is: T; readonly problem: string } | null> {
  let refused: { readonly is: T; readonly at: number; readonly problem: string } | null = null;
  const isRefused = (): boolean => refused !== null;
  function* wanted(): Generator<Wanted<T>> {
    for (const run of runs) {
      if (isRefused()) return;
      yield run;
    }
  }
  const lasting = lanes.map((lane) => ({ lane, stop: () => undefined }));
  await inLanes(wanted(), lasting, async ({ is, request }, at, { lane }) => {
    const result = await resultOf(request, lane);
    if (!('problem' in result)) made(is, result);
    // Of several that run side by side the first one is told, whichever ends first.
    else if (refused === null || at < refused.at) refused = { is, at, problem: result.problem };
  });
  return refused;
}

async function resultOf(request: RunRequest, lane: Lane): Promise<RunMade | Problem> {
  const answer = await lane.ask(request);
  if ('result' in answer) return 'refused' in answer.result ? { problem: answer.result.refused } : answer.result;
  if (answer.reason.code === 'broken')
    return { problem: `something broke inside. Please report this.\n${String(answer.reason.params['problem'])}` };
  return { outcome: stuckOutcome(hasTask(request.setup.scene)), verdict: null };
}

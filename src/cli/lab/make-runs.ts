import { Asker, inLanes } from '#check/lane';
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

/**
 * Makes runs side by side, in threads that live until the last one. What they come to does not depend on their number.
 *
 * @param made called with each result, in the order in which they end
 * @returns `null`, or why a run was refused: then the others are given up
 */
export async function makeRuns<T>(
  runs: Iterable<Wanted<T>>,
  jobs: number,
  made: (is: T, result: RunMade) => void,
): Promise<{ readonly is: T; readonly problem: string } | null> {
  const firmware = await WebAssembly.compile(readFirmware());
  const start = threads<RunRequest, RunAnswer>('lab-worker', (): Omit<RunnerData, 'shared'> => ({ firmware }));
  // A run has as long as it takes: only one without a sign of life is given up.
  const lanes = Array.from({ length: jobs }, () => new Asker(start, every, Infinity));
  let refused: { readonly is: T; readonly at: number; readonly problem: string } | null = null;
  const isRefused = (): boolean => refused !== null;
  function* wanted(): Generator<Wanted<T>> {
    for (const run of runs) {
      if (isRefused()) return;
      yield run;
    }
  }
  await inLanes(wanted(), lanes, async ({ is, request }, at, lane) => {
    const result = await resultOf(request, lane);
    if (!('problem' in result)) made(is, result);
    // Of several that run side by side the first one is told, whichever ends first.
    else if (refused === null || at < refused.at) refused = { is, at, problem: result.problem };
  });
  return refused;
}

async function resultOf(request: RunRequest, lane: Asker<RunRequest, RunAnswer>): Promise<RunMade | Problem> {
  const answer = await lane.ask(request);
  if ('result' in answer) return 'refused' in answer.result ? { problem: answer.result.refused } : answer.result;
  if (answer.reason.code === 'broken')
    return { problem: `something broke inside. Please report this.\n${String(answer.reason.params['problem'])}` };
  return { outcome: stuckOutcome(hasTask(request.setup.scene)), verdict: null };
}

import type { ProbeAnswer, ProbeTask, SweepTask } from './messages';
import { runBare, sweepBare } from './run-bare';

addEventListener('message', ({ data }: MessageEvent<ProbeTask | SweepTask>) => {
  const answer = (message: ProbeAnswer): void => {
    // The worker's own postMessage; the compiler takes it for a window's.
    (postMessage as (message: ProbeAnswer) => void)(message);
  };
  const said =
    'vary' in data ? sweepBare(data).then((table) => ({ table })) : runBare(data).then((result) => ({ result }));
  said.then(answer, (error: unknown) =>
    answer({ problem: error instanceof Error ? (error.stack ?? error.message) : String(error) }),
  );
});

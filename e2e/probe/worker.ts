import type { ProbeAnswer, ProbeTask } from './messages';
import { runBare } from './run-bare';

addEventListener('message', (event: MessageEvent<ProbeTask>) => {
  const answer = (message: ProbeAnswer): void => {
    // The worker's own postMessage; the compiler takes it for a window's.
    (postMessage as (message: ProbeAnswer) => void)(message);
  };
  runBare(event.data).then(
    (result) => answer({ result }),
    (error: unknown) => answer({ problem: error instanceof Error ? (error.stack ?? error.message) : String(error) }),
  );
});

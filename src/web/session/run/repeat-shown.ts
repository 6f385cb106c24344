import type { PageParts } from '../../kit/parts';
import type { RunParts } from './parts';
import { repeatInWorker, type Repeated, type RepeatWish } from './repeat-client';

/** Shorter waits are not announced, in ms. */
const PATIENCE_MS = 500;
/** The share is announced again after this many percent, or after this many ms: a message lives for twelve seconds. */
const NEWS_PERCENT = 10;
const NEWS_MS = 5000;

/**
 * Repeats a recorded run to its end. If that takes long, a message shows the progress and offers to give up.
 *
 * @param say the message at this share, in percent
 * @returns `null`: it was given up
 * @throws Error (as a rejection) when the run cannot be made, or the VM cannot be loaded
 */
export async function repeatShown(
  { notices, run }: Pick<PageParts, 'notices'> & Pick<RunParts, 'run'>,
  wish: RepeatWish,
  say: (percent: number) => string,
  giveUp = new AbortController(),
): Promise<Repeated | null> {
  const startMs = performance.now();
  let [toldMs, told] = [-Infinity, -Infinity];
  let shown: object | null = null;
  function tell(nowUs: number): void {
    const nowMs = performance.now();
    const percent = Math.min(Math.floor((100 * nowUs) / Math.max(wish.untilUs, 1)), 99);
    if (nowMs - startMs < PATIENCE_MS || (percent < told + NEWS_PERCENT && nowMs - toldMs < NEWS_MS)) return;
    [toldMs, told] = [nowMs, percent];
    const action = { key: 'code.cancel', run: () => giveUp.abort() } as const;
    notices.show({ kind: 'info', key: 'notice.text', values: { text: say(percent) }, action });
    shown = notices.current.value;
  }
  try {
    return await repeatInWorker(run.engine, wish, tell, giveUp.signal);
  } catch (error) {
    if (giveUp.signal.aborted) return null;
    throw error;
  } finally {
    if (shown !== null && notices.current.value === shown) notices.close();
  }
}

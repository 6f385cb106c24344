/** Longest wait for a moment in which the page has nothing to do, in ms. Chosen. */
const AT_LATEST_MS = 2000;

/** Calls `act` once the page has nothing more urgent to do. */
export function whenIdle(act: () => void): void {
  const idle = window.requestIdleCallback as typeof window.requestIdleCallback | undefined;
  if (idle === undefined) setTimeout(act, 500);
  else idle(act, { timeout: AT_LATEST_MS });
}

/** Longest wait for a moment in which the page has nothing to do, in ms. Chosen. */
const AT_LATEST_MS = 2000;

/** Calls `act` once the page has nothing more urgent to do. */
export function whenIdle(act: () => void): void {
  if ('requestIdleCallback' in window) requestIdleCallback(act, { timeout: AT_LATEST_MS });
  else setTimeout(act, 500); // Safari
}

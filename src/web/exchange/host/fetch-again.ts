/** How long is waited between two tries, in ms. Chosen: most gaps in the network of a school are over by then. */
const WAITS_MS = [500, 2000, 8000];

/**
 * Fetches a part of the app, with retries in case the network is interrupted for a moment. Some browsers (Firefox)
 * remember that a module failed to load: there it stays missing until the page is loaded anew.
 *
 * @param wait waits this many ms
 * @throws what `get` rejected with at last (as a rejection)
 */
export async function fetchAgain<T>(get: () => Promise<T>, wait = aWhile): Promise<T> {
  for (const ms of WAITS_MS) {
    try {
      return await get();
    } catch {
      await wait(ms);
    }
  }
  return get();
}

const aWhile = (ms: number): Promise<void> => new Promise((resolve) => setTimeout(resolve, ms));

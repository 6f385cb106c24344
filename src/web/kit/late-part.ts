import type { Notice, NoticesModel } from './notices';

/**
 * The notice that a part of the page could not be loaded: the network is gone, or the server has another version by
 * now.
 */
export const latePart: Notice = {
  kind: 'error',
  key: 'notice.latePart',
  action: { key: 'notice.reload', run: () => location.reload() },
};

/** Time after a press for which its effect is awaited, in ms. Chosen: a network that hangs gives up by then. */
const WAITED_MS = 30_000;

/**
 * Shows a notice when a part of the page cannot be loaded within `WAITED_MS` of a press. Without a press nobody has
 * asked for the part: the page was fetching ahead.
 *
 * @returns a function that ends it
 */
export function noticeMissingParts(notices: Pick<NoticesModel, 'show'>): () => void {
  let pressedMs = -Infinity;
  const press = (): void => {
    pressedMs = performance.now();
  };
  const missing = (): void => {
    if (performance.now() - pressedMs <= WAITED_MS) notices.show(latePart);
  };
  const presses = ['pointerdown', 'keydown', 'click'];
  for (const name of presses) addEventListener(name, press, true);
  addEventListener('vite:preloadError', missing); // of the loader that the build puts around every import()
  return () => {
    for (const name of presses) removeEventListener(name, press, true);
    removeEventListener('vite:preloadError', missing);
  };
}

import type { Notice, NoticesModel } from './notices';

/** A part of the page that comes late did not come: the network is gone, or the server has another version by now. */
export const latePart: Notice = {
  kind: 'error',
  key: 'notice.latePart',
  action: { key: 'notice.reload', run: () => location.reload() },
};

/** Time after a press for which its effect is awaited, in ms. Chosen: a network that hangs gives up by then. */
const WAITED_MS = 30_000;

/**
 * Tells of every late part that does not come, whoever has asked for it. Without a press before it, nobody has: what the page
 * fetches ahead it may do without.
 *
 * @returns ends it
 */
export function tellLateParts(notices: Pick<NoticesModel, 'show'>): () => void {
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

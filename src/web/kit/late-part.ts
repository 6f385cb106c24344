import { MISSED_VIEW } from './late-view';
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

/** Most requests for what nobody has pressed for, and the time before the next one, in ms. Chosen: a classroom's network comes back after a second or two. */
const TRIES = 4;
const RETRY_MS = 1500;

/**
 * Shows a notice when a part of the page cannot be loaded within `WAITED_MS` of a press. Without a press nobody has
 * asked for the part: the page was fetching ahead. Views that are missing are asked for again by the notice's button, by
 * themselves where nobody has pressed, and when the connection is back. Style sheets that are missing are asked for again
 * with them, and with the next press.
 *
 * @returns a function that ends it
 */
export function noticeMissingParts(notices: Pick<NoticesModel, 'show'>): () => void {
  let pressedMs = -Infinity;
  const missed = new Set<() => void>();
  const sheets = new Set<HTMLLinkElement>();
  const askForSheets = (): void => {
    const lost = [...sheets];
    sheets.clear();
    for (const sheet of lost) sheet.replaceWith(sheet.cloneNode());
  };
  const ask = (): void => {
    askForSheets();
    const waiting = [...missed];
    missed.clear();
    for (const retry of waiting) retry();
  };
  const press = (): void => {
    askForSheets();
    pressedMs = performance.now();
  };
  const isAwaited = (): boolean => performance.now() - pressedMs <= WAITED_MS;
  let tries = 0;
  const missing = (): void => {
    if (!isAwaited()) return;
    notices.show(missed.size > 0 ? { ...latePart, action: { key: 'notice.again', run: ask } } : latePart);
  };
  const keep = (event: Event): void => {
    event.preventDefault();
    missed.add((event as CustomEvent<() => void>).detail);
    if (!isAwaited() && ++tries < TRIES) setTimeout(ask, RETRY_MS);
    missing();
  };
  // The loader that the build puts around every import() asks for a style sheet once only.
  const loseSheet = ({ target }: Event): void => {
    if (target instanceof HTMLLinkElement && target.rel === 'stylesheet') sheets.add(target);
  };
  const listeners: readonly (readonly [string, (event: Event) => void])[] = [
    ...['pointerdown', 'keydown', 'click'].map((name) => [name, press] as const),
    ['vite:preloadError', missing], // of the loader that the build puts around every import()
    [MISSED_VIEW, keep],
    ['error', loseSheet],
    ['online', ask],
  ];
  for (const [name, listener] of listeners) addEventListener(name, listener, true);
  return () => {
    for (const [name, listener] of listeners) removeEventListener(name, listener, true);
  };
}

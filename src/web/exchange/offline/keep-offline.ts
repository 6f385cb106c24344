import { lateBar } from './late-bar';
import { versionLock, type ToServiceWorker } from './versions';

/** A page that stays open looks for a new version at most so often, in ms. */
const LOOK_EVERY_MS = 3_600_000; // chosen: a school day has a few lessons

/** Keeps the app for visits without a network, and offers new versions, if the browser has service workers. */
export async function keepOffline(): Promise<void> {
  const workers = serviceWorkers();
  const entry = document.querySelector<HTMLScriptElement>('script[type=module][src]')?.src;
  if (workers === null || entry === undefined) return;
  await holdVersion(entry);
  send(workers.controller, { type: 'tidy' });
  const address = new URL('sw.js', document.baseURI);
  const offer = offerUpdates(workers);
  if (!isWanted()) return;
  try {
    const registration = await workers.register(address, { updateViaCache: 'none' });
    offer(registration);
    lookNowAndThen(registration);
  } catch {
    // A private window, a full disk, a host without that file: the app then needs the network, as any page.
  }
}

/** The browser's service workers; asking throws in some frames. */
function serviceWorkers(): ServiceWorkerContainer | null {
  try {
    return 'serviceWorker' in navigator && 'locks' in navigator ? navigator.serviceWorker : null;
  } catch {
    return null;
  }
}

/** True for a page of its own; in a frame only if the host asks for it, as with the micro:bit simulator: `flag=sw`. */
function isWanted(): boolean {
  const flags = new URLSearchParams(location.search).getAll('flag');
  return self === top || flags.includes('sw') || flags.includes('*');
}

/** Holds the lock of this page's version as long as the page lives: the files of that version are needed. */
function holdVersion(entry: string): Promise<void> {
  return new Promise((resolve) => {
    navigator.locks
      .request(versionLock(entry), { mode: 'shared' }, () => {
        resolve();
        return new Promise<void>(() => {});
      })
      .catch(() => resolve());
  });
}

function send(to: ServiceWorker | null, message: ToServiceWorker): void {
  to?.postMessage(message);
}

/**
 * Asks before a new version takes over. A yes in one tab changes the version for all: the others go on with their
 * files, which stay, and are asked in turn. No page is ever reloaded by itself.
 */
function offerUpdates(workers: ServiceWorkerContainer): (registration: ServiceWorkerRegistration) => void {
  let isAccepted = false;
  let hadController = workers.controller !== null;
  let waiting: ServiceWorker | null = null;
  function offer(worker: ServiceWorker | null): void {
    waiting = worker;
    void lateBar(({ offerUpdate }) => offerUpdate(accept));
  }
  function accept(): void {
    isAccepted = true;
    // The work is saved as the page is left (`keep-work.ts`).
    if (waiting?.state === 'installed') send(waiting, { type: 'take-over' });
    else location.reload();
  }
  workers.addEventListener('controllerchange', () => {
    if (isAccepted) location.reload();
    else if (hadController) offer(null);
    hadController = true;
  });
  return (registration) => {
    if (registration.waiting !== null && hadController) offer(registration.waiting);
    const follow = (): void => {
      const { installing } = registration;
      installing?.addEventListener('statechange', () => {
        if (installing.state === 'installed' && hadController) offer(installing);
        if (installing.state === 'redundant' && waiting === installing)
          void lateBar(({ takeBackUpdate }) => takeBackUpdate());
      });
    };
    follow();
    registration.addEventListener('updatefound', follow);
  };
}

function lookNowAndThen(registration: ServiceWorkerRegistration): void {
  let lookedMs = performance.now();
  document.addEventListener('visibilitychange', () => {
    if (document.visibilityState !== 'visible' || performance.now() - lookedMs < LOOK_EVERY_MS) return;
    lookedMs = performance.now();
    registration.update().catch(() => undefined);
  });
}

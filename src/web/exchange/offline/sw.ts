/**
 * The service worker: keeps all files of one version of the app, so that it opens and runs without a network (decision 0017).
 * The build puts the list of files into `__WB_MANIFEST` (`scripts/service-worker.mjs`) and the result beside the page as `sw.js`.
 */
import { PrecacheController, type PrecacheEntry } from 'workbox-precaching';

import { FILES_LOCK, isMessage, pageUrl, versionLocks } from './versions';

declare const self: ServiceWorkerGlobalScope & {
  readonly __WB_MANIFEST: PrecacheEntry[];
  /** Another rest than `REST_MS`: browser tests wait for all files, and no robot drives meanwhile. */
  readonly PARCOURS_REST_MS?: number;
};

/**
 * Rest before each file that is fetched, in ms. Chosen: pupils press Run at once and watch a robot drive while the files come
 * one after the other. Without the rest Chromium was at work on them with a third of a processor, with it a fifth (measured on a
 * busy machine); all in all they take 5 s longer.
 */
const REST_MS = 25;

const files = new PrecacheController({
  plugins: [
    {
      requestWillFetch: async ({ request }) => {
        await new Promise((resolve) => setTimeout(resolve, self.PARCOURS_REST_MS ?? REST_MS));
        return request;
      },
    },
  ],
});
files.addToCacheList(self.__WB_MANIFEST);
const CACHE = files.strategy.cacheName;

// All files or none: one that cannot be had, or is not what the list says, fails the installation, and the version before
// stays. What has come stays too, and is not fetched again by the next try.
self.addEventListener('install', (event) => {
  event.waitUntil(navigator.locks.request(FILES_LOCK, () => files.install(event)));
});

// The page of the first visit is served, too: its late parts come without a network from now on.
self.addEventListener('activate', (event) => {
  event.waitUntil(self.clients.claim());
});

self.addEventListener('message', (event) => {
  if (!isMessage(event.data)) return;
  if (event.data.type === 'take-over') event.waitUntil(self.skipWaiting());
  else event.waitUntil(navigator.locks.request(FILES_LOCK, tidy));
});

self.addEventListener('fetch', (event) => {
  const { request } = event;
  if (request.method !== 'GET' || !request.url.startsWith(self.registration.scope)) return;
  // A page is the same whatever its address asks of it.
  const url = request.mode === 'navigate' ? pageUrl(request.url) : request.url;
  const key = files.getCacheKeyForURL(url);
  // Ignores navigations to anything but the app's pages. A file unknown to this version may belong to the previous one,
  // whose pages may still be open.
  if (key === undefined && request.mode === 'navigate') return;
  event.respondWith(kept(key ?? url, request));
});

async function kept(key: string, request: Request): Promise<Response> {
  const cache = await caches.open(CACHE);
  return (await cache.match(key, { ignoreVary: true })) ?? fetch(request);
}

/**
 * Gives up the files of earlier versions, once no page of them is open. Only once per version: what comes later belongs to
 * a version to come.
 */
async function tidy(): Promise<void> {
  const { installing, waiting } = self.registration;
  const mark = `${self.registration.scope}?tidied=${files.getCacheKeyForURL(pageUrl(self.registration.scope)) ?? ''}`;
  const cache = await caches.open(CACHE);
  if (installing !== null || waiting !== null || (await cache.match(mark)) !== undefined) return;
  if (!(await areAllPagesOurs())) return;
  const ours = new Set(files.getURLsToCacheKeys().values());
  for (const request of await cache.keys()) {
    if (!ours.has(request.url)) await cache.delete(request);
  }
  await cache.put(mark, new Response());
}

/** Every page says its version by a lock; one that does not yet is still being loaded, and may be of any version. */
async function areAllPagesOurs(): Promise<boolean> {
  const pages = await self.clients.matchAll({ type: 'window', includeUncontrolled: true });
  const { held } = await navigator.locks.query();
  const entries = versionLocks((held ?? []).map(({ name }) => name ?? ''));
  return entries.length >= pages.length && entries.every((entry) => files.getCacheKeyForURL(entry) !== undefined);
}

/** The agreement between pages and service worker. */

/** Lock for adding or removing cached files. */
export const FILES_LOCK = 'parcours.files';

const VERSION = 'parcours.version ';

/** Messages of a page to the service worker. */
export type ToServiceWorker =
  /** The new version may serve all pages from now on: the pupil wants it. */
  | { readonly type: 'take-over' }
  /** A page holds its version's lock now: files that are no longer needed may go. */
  | { readonly type: 'tidy' };

/** True if something that came as a message is one of ours. */
export function isMessage(data: unknown): data is ToServiceWorker {
  const type = typeof data === 'object' && data !== null && 'type' in data ? data.type : null;
  return type === 'take-over' || type === 'tidy';
}

/** The lock that a page holds as long as it lives; its version is known by the file with which it begins, whose name changes with every other file. */
export const versionLock = (entryUrl: string): string => VERSION + entryUrl;

/** The files with which the open pages begin, by the locks that are held. */
export const versionLocks = (held: readonly string[]): readonly string[] =>
  held.filter((name) => name.startsWith(VERSION)).map((name) => name.slice(VERSION.length));

/** The file behind a page's address: without its query and fragment, and with the name that a folder's page has. */
export function pageUrl(address: string): string {
  const url = new URL(address);
  return url.origin + url.pathname.replace(/\/$/, '/index.html');
}

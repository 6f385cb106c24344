import type { Watcher } from './news';

/** A thing that a camera has seen counts as in its picture for so long, in ms. Chosen as for the line: it may be lost for a moment. */
const GONE_AFTER_MS = 600;
const LINE = 'line';

/** Finds out when a camera finds something new, and when it finds nothing any more. */
export function watchCamera(): Watcher {
  const lastSeen = new Map<number | typeof LINE, number>();
  let before = '';
  return (seen) => {
    if (seen.inPicture === null) return [];
    for (const { isLine, id } of seen.inPicture) lastSeen.set(isLine ? LINE : id, seen.atMs);
    for (const [one, atMs] of lastSeen) if (seen.atMs - atMs >= GONE_AFTER_MS) lastSeen.delete(one);
    const ids = [...lastSeen.keys()].filter((one) => one !== LINE).sort((one, other) => one - other);
    const isLine = lastSeen.has(LINE);
    const now = [isLine, ...ids].join();
    const isNews = before !== now && (before !== '' || lastSeen.size > 0);
    before = now;
    return isNews ? [{ topic: 'camera', isLine, ids, seen }] : [];
  };
}

import type { ShelfWork } from '#check/shelf/shelf';
import { workToText } from '#check/shelf/write-shelf';
import { documentOfText } from '#intake/text';

import { readyScene } from '../../session/work/catalogue/ready-courses';
import { entriesIn, inStore, type Entry } from '../../session/work/storage/database';

/** Names of the works of the shelf in the browser's database. */
const PREFIX = 'shelf.';

/** A work as it is stored. */
export interface StoredWork {
  readonly key: string;
  readonly text: string;
  readonly work: ShelfWork;
}

/** The works of the shelf that are stored in this browser, each as its file; the newest first. Rejects without a database. */
export async function storedWorks(): Promise<readonly StoredWork[]> {
  const entries = await entriesIn(IDBKeyRange.bound(PREFIX, `${PREFIX}~`));
  return entries
    .flatMap(({ name, text }) => {
      const work = workIn(text);
      return work === null ? [] : [{ key: name.slice(PREFIX.length), text, work }]; // of a newer version: it stays where it is
    })
    .toReversed();
}

/** Stores a work. Rejects where there is no room. */
export const storeWork = (key: string, text: string): Promise<void> =>
  inStore('readwrite', (store) => void store.put(entryOf(key, text)));

/**
 * Changes a stored work as it lies there now, so that what another tab has changed in it stays. One that was deleted there
 * is stored anew, from `otherwise`. Rejects where there is no room.
 *
 * @returns the work as it is now
 */
export async function changeStored(
  key: string,
  otherwise: ShelfWork,
  change: (work: ShelfWork) => ShelfWork,
): Promise<StoredWork> {
  let work = otherwise;
  let text = '';
  await inStore('readwrite', (store) => {
    const request = store.getAll(PREFIX + key) as IDBRequest<Entry[]>;
    request.onsuccess = () => {
      work = change(workIn(request.result[0]?.text ?? '') ?? otherwise);
      text = workToText(work);
      store.put(entryOf(key, text));
    };
  });
  return { key, text, work };
}

/** Deletes works. */
export const forgetWorks = (keys: readonly string[]): Promise<void> =>
  inStore('readwrite', (store) => {
    for (const key of keys) store.delete(PREFIX + key);
  });

const entryOf = (key: string, text: string): Entry => ({ name: PREFIX + key, text, usedMs: Infinity });

/** The work in a text; `null`: it is none. */
function workIn(text: string): ShelfWork | null {
  const document = documentOfText(text, readyScene);
  if (document.kind === 'project') return { kind: 'task', project: document.project };
  return document.kind === 'series' ? { kind: 'series', series: document.series } : null;
}

/** The copies of all tabs, in the storage for text and on the disk. Which of them may go, and when. */
import { entriesIn, inStore } from './database';
import { allCopies, DISK_COPY } from './disk-copy';
import { savedMsOf } from './history';
import { copiesOf, dropCopy, newer } from './tab-storage';

/** The later copy of each tab, by its name. */
export async function laterCopies(): Promise<ReadonlyMap<string, string>> {
  const texts = new Map(copiesOf(localStorage));
  for (const [tab, text] of await copiesOnDisk().catch(() => [])) texts.set(tab, newer(texts.get(tab) ?? null, text) ?? text); // prettier-ignore
  return texts;
}

/**
 * Makes room in the storage for text: copies of other tabs that are on the disk as well are left to it.
 *
 * @returns whether there were any
 */
export async function dropDoubled(own: string): Promise<boolean> {
  const onDisk = new Map(await copiesOnDisk());
  const doubled = copiesOf(localStorage).filter(([tab, text]) => {
    const other = onDisk.get(tab);
    return tab !== own && other !== undefined && savedMsOf(other) >= savedMsOf(text);
  });
  for (const [tab] of doubled) dropCopy(localStorage, tab);
  return doubled.length > 0;
}

/** Deletes the copies of these tabs in both places. */
export async function dropCopies(tabs: readonly string[]): Promise<void> {
  for (const tab of tabs) dropCopy(localStorage, tab);
  if (tabs.length === 0) return;
  await inStore('readwrite', (store) => {
    for (const tab of tabs) store.delete(DISK_COPY + tab);
  });
}

const copiesOnDisk = async (): Promise<readonly (readonly [tab: string, text: string])[]> =>
  (await entriesIn(allCopies())).map(({ name, text }) => [name.slice(DISK_COPY.length), text]);

import { unread } from '#check/hand-in/unread';
import type { TreeFile } from '#intake/tree';

/** A file with its path in the folder that was chosen or dropped; alone it has just its name. */
export interface AddedFile {
  readonly path: string;
  readonly file: File;
}

/** The dropped files, including those in folders. */
export async function droppedFiles({ items, files }: DataTransfer): Promise<readonly AddedFile[]> {
  // Entries must be asked for before anything is waited for: the browser takes them away with the event.
  const entries = [...items].map((item) => item.webkitGetAsEntry());
  if (entries.every((entry) => entry === null)) return [...files].map((file) => ({ path: file.name, file }));
  const found = await Promise.all(entries.flatMap((entry) => (entry === null ? [] : [filesIn(entry, '')])));
  return found.flat();
}

async function filesIn(entry: FileSystemEntry, above: string): Promise<readonly AddedFile[]> {
  const path = `${above}${entry.name}`;
  if (entry.isFile) {
    const file = await new Promise<File>((resolve, reject) => (entry as FileSystemFileEntry).file(resolve, reject));
    return [{ path, file }];
  }
  const reader = (entry as FileSystemDirectoryEntry).createReader();
  const found: AddedFile[] = [];
  // It gives a hundred at a time, until there is none.
  for (;;) {
    const some = await new Promise<FileSystemEntry[]>((resolve, reject) => reader.readEntries(resolve, reject));
    if (some.length === 0) return found;
    for (const one of some) found.push(...(await filesIn(one, `${path}/`)));
  }
}

/** The files chosen in a dialog of the browser, or those of a folder. */
export const chosenFiles = (files: Iterable<File>): readonly AddedFile[] =>
  [...files].map((file) => ({ path: file.webkitRelativePath || file.name, file }));

/** An added file as the intake reads it. */
export const treeFile = ({ path, file }: AddedFile): TreeFile => ({
  path,
  size: file.size,
  async read(maxBytes) {
    if (file.size > maxBytes) return unread('large', { file: file.name, most: maxBytes });
    return { bytes: new Uint8Array(await file.arrayBuffer()) };
  },
});

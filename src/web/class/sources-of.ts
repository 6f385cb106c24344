import { folderSources, sourcesIn, type Most, type Source, type TreeFile } from '#check/hand-in/sources';
import { unread } from '#check/hand-in/unread';

import type { AddedFile } from '../page/files/added-files';
import { readyScene } from '../work/catalogue/ready-courses';

/** Chosen: a tablet's browser holds it beside the workers. */
const MOST: Most = { zip: 200_000_000, list: 20_000_000 };

/** The hand-ins of files and folders that were chosen or dropped, each as the command line takes it. */
export async function sourcesOf(added: readonly AddedFile[]): Promise<readonly Source[]> {
  const folders = new Map<string, TreeFile[]>();
  const found: Source[] = [];
  for (const { path, file } of added) {
    const [top = '', ...below] = path.split('/');
    if (below.length === 0) found.push(...(await sourcesIn(treeFile(path, file), MOST, readyScene)));
    else folders.set(top, [...(folders.get(top) ?? []), treeFile(below.join('/'), file)]);
  }
  return [...found, ...[...folders.values()].flatMap((inside) => folderSources(inside, readyScene))];
}

const treeFile = (path: string, file: File): TreeFile => ({
  path,
  async read(maxBytes) {
    if (file.size > maxBytes) return unread('large', { file: file.name, most: maxBytes });
    return { bytes: new Uint8Array(await file.arrayBuffer()) };
  },
});

import { givenFile, givenFolder, together, type Given, type Most, type Source } from '#check/hand-in/sources';
import type { TreeFile } from '#check/hand-in/tree';
import { unread } from '#check/hand-in/unread';

import type { AddedFile } from '../page/files/added-files';
import { readyScene } from '../work/catalogue/ready-courses';

/** Chosen: a tablet's browser holds it beside the workers. */
const MOST: Most = { zip: 200_000_000, list: 20_000_000 };

/** The hand-ins of files and folders that were chosen or dropped, each as the command line takes it. */
export async function sourcesOf(added: readonly AddedFile[]): Promise<readonly Source[]> {
  const folders = new Map<string, TreeFile[]>();
  const found: Given[] = [];
  const isAlone = new Set(added.map(({ path }) => path.split('/', 1)[0])).size === 1;
  for (const { path, file } of added) {
    const [top = '', ...below] = path.split('/');
    if (below.length === 0) found.push(await givenFile(treeFile(path, file), MOST, readyScene, isAlone));
    else folders.set(top, [...(folders.get(top) ?? []), treeFile(below.join('/'), file)]);
  }
  const inFolders = [...folders].map(([name, inside]) => givenFolder(name, inside, readyScene, isAlone));
  return together([...found, ...inFolders]).map(inItsTurn);
}

/** Whoever looks at the page is served between two hand-ins: a large one takes its time. */
const inItsTurn = (source: Source): Source => ({
  ...source,
  async read() {
    await new Promise((resolve) => setTimeout(resolve));
    return source.read();
  },
});

const treeFile = (path: string, file: File): TreeFile => ({
  path,
  size: file.size,
  async read(maxBytes) {
    if (file.size > maxBytes) return unread('large', { file: file.name, most: maxBytes });
    return { bytes: new Uint8Array(await file.arrayBuffer()) };
  },
});

/** Reading what was handed in, in a worker of its own: zips are unpacked and texts looked through beside the page. */
import type { Content } from '#intake/contents';
import { contentOf, givenFile, givenFolder, together, type Given, type Most, type Source } from '#intake/sources';
import type { TreeFile } from '#intake/tree';
import { unread } from '#check/hand-in/unread';
import type { Scene } from '#scene/scene';

import type { AddedFile } from '../../page/files/added-files';

/** From the page: files that were handed in together, and then which of their hand-ins is wanted. */
export type ToReader =
  | {
      readonly type: 'read-open';
      readonly batch: number;
      readonly added: readonly AddedFile[];
      /** The scenes of the ready courses by their names: links name them. */
      readonly scenes: Readonly<Record<string, Scene>>;
    }
  | { readonly type: 'read'; readonly batch: number; readonly place: number };

/** To the page: the answers, in the same order. */
export type FromReader =
  | { readonly type: 'read-names'; readonly names: readonly string[] }
  | { readonly type: 'read-content'; readonly content: Content };

/** Chosen: a tablet's browser holds it beside the workers. */
const MOST: Most = { zip: 200_000_000, list: 20_000_000 };

/** Reads what it is sent; never throws. */
export class Reader {
  private readonly batches = new Map<number, readonly Source[]>();

  async answer(message: ToReader): Promise<FromReader> {
    if (message.type === 'read-open') {
      const { batch, added, scenes } = message;
      const sources = await sourcesOf(added, (id) => (Object.hasOwn(scenes, id) ? (scenes[id] ?? null) : null));
      this.batches.set(batch, sources);
      return { type: 'read-names', names: sources.map(({ name }) => name) };
    }
    const source = this.batches.get(message.batch)?.[message.place];
    const content = source === undefined ? unread('gone', { problem: '' }) : await contentOf(source);
    return { type: 'read-content', content };
  }
}

/** The hand-ins of files and folders that were chosen or dropped, each as the command line takes it. */
async function sourcesOf(
  added: readonly AddedFile[],
  courses: (id: string) => Scene | null,
): Promise<readonly Source[]> {
  const folders = new Map<string, TreeFile[]>();
  const found: Given[] = [];
  const isAlone = new Set(added.map(({ path }) => path.split('/', 1)[0])).size === 1;
  for (const { path, file } of added) {
    const [top = '', ...below] = path.split('/');
    if (below.length === 0) found.push(await givenFile(treeFile(path, file), MOST, courses, isAlone));
    else {
      const inside = folders.get(top);
      if (inside === undefined) folders.set(top, [treeFile(below.join('/'), file)]);
      else inside.push(treeFile(below.join('/'), file));
    }
  }
  const inFolders = [...folders].map(([name, inside]) => givenFolder(name, inside, courses, isAlone));
  return together([...found, ...inFolders]);
}

const treeFile = (path: string, file: File): TreeFile => ({
  path,
  size: file.size,
  async read(maxBytes) {
    if (file.size > maxBytes) return unread('large', { file: file.name, most: maxBytes });
    return { bytes: new Uint8Array(await file.arrayBuffer()) };
  },
});

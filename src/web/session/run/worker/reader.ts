/** Reads hand-ins, in a worker of its own: zips are unpacked and texts searched beside the page. */
import { unread } from '#check/hand-in/unread';
import type { Content } from '#intake/contents';
import { openGiven, type Opened } from '#intake/file';
import { seriesAmong, type SeriesAmong } from '#intake/series-among';
import { contentOf, givenFile, givenFolder, together, type Given, type Source } from '#intake/sources';
import type { TreeFile } from '#intake/tree';
import { isLitter } from '#intake/zip';
import type { ReadyCourses } from '#project/link/link';
import type { Scene } from '#scene/scene';

import { treeFile, type AddedFile } from '../../../kit/files/added-files';

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
  | {
      readonly type: 'read-names';
      readonly names: readonly string[];
      /** The series found among the files: it is not a hand-in. `null`: there is none. */
      readonly series: SeriesAmong['document'] | null;
    }
  | { readonly type: 'read-content'; readonly content: Content }
  /** Its code did not come. */
  | { readonly type: 'read-unloaded' };

/** Reads the files it receives; never throws. */
export class Reader {
  private readonly batches = new Map<number, readonly Source[]>();

  async answer(message: ToReader): Promise<FromReader> {
    if (message.type === 'read-open') {
      const { batch, added, scenes } = message;
      const courses: ReadyCourses = (id) => (Object.hasOwn(scenes, id) ? (scenes[id] ?? null) : null);
      const opened = await Promise.all(added.map(treeFile).map(openedAtTop));
      const among = await seriesAmong(opened, courses);
      const sources = await sourcesOf(among?.rest ?? opened, courses);
      this.batches.set(batch, sources);
      return { type: 'read-names', names: sources.map(({ name }) => name), series: among?.document ?? null };
    }
    const source = this.batches.get(message.batch)?.[message.place];
    const content = source === undefined ? unread('gone', { problem: '' }) : await contentOf(source);
    return { type: 'read-content', content };
  }
}

/** Opens a file that was added by itself; one in a folder is left closed, a zip there is opened later. */
const openedAtTop = async (file: TreeFile): Promise<Opened> =>
  file.path.includes('/') ? { file, zip: null } : openGiven(file);

/** The hand-ins of files and folders that were chosen or dropped, each as the command line takes it. */
async function sourcesOf(all: readonly Opened[], courses: ReadyCourses): Promise<readonly Source[]> {
  const folders = new Map<string, TreeFile[]>();
  const found: Given[] = [];
  const tops = all.map(({ file }) => file.path.split('/', 1)[0] ?? '').filter((name) => !isLitter(name));
  const isAlone = new Set(tops).size === 1;
  for (const opened of all) {
    const [top = '', ...below] = opened.file.path.split('/');
    const file = { ...opened.file, path: below.join('/') };
    if (below.length === 0) found.push(await givenFile(opened, courses, isAlone));
    else if (folders.get(top)?.push(file) === undefined) folders.set(top, [file]);
  }
  const inFolders = [...folders].map(([name, inside]) => givenFolder(name, inside, courses, isAlone));
  return together([...found, ...inFolders]);
}

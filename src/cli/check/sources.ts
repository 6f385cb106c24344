import { readdirSync, readFileSync, statSync } from 'node:fs';
import { basename, join } from 'node:path';
import { isTextWithLinks } from '#check/hand-in/links';
import {
  brokenSource,
  fileSource,
  folderSources,
  handInName,
  linkSource,
  listSources,
  withOwnNames,
  zipSources,
  type Source,
  type TreeFile,
} from '#check/hand-in/sources';
import { unread } from '#check/hand-in/unread';
import { isAddress } from '../read-work';
import { readyCourse } from '../ready-courses';
import { reasonOf } from '../reason-of';

/** Largest zip, and largest file of links. Chosen: fits in memory beside the runs. */
const MOST_ZIP_BYTES = 500_000_000;
const MOST_LIST_BYTES = 20_000_000;

/**
 * Finds the hand-ins behind the words of the command line, in their order, those of a folder by their names: project files
 * and programs, folders and zips of them, files of links, links.
 *
 * @returns or what is wrong: a path that does not exist
 */
export function findHandIns(
  paths: readonly string[],
): { readonly sources: readonly Source[] } | { readonly problem: string } {
  const found: Source[] = [];
  for (const path of paths) {
    const here = isAddress(path) ? [linkSource({ name: '', address: path }, 0, readyCourse)] : sourcesAt(path);
    if ('problem' in here) return here;
    found.push(...here);
  }
  return { sources: withOwnNames(found) };
}

function sourcesAt(path: string): readonly Source[] | { readonly problem: string } {
  try {
    const status = statSync(path);
    const name = basename(path);
    if (status.isDirectory()) return folderSources(filesIn(path), readyCourse);
    if (/\.zip$/i.test(path)) {
      if (status.size > MOST_ZIP_BYTES) return [tooLarge(name, MOST_ZIP_BYTES)];
      return zipSources(name, readFileSync(path), readyCourse);
    }
    if (!isTextWithLinks(path)) return [fileSource(treeFile(path, name), readyCourse)];
    if (status.size > MOST_LIST_BYTES) return [tooLarge(handInName(name), MOST_LIST_BYTES)];
    const linked = listSources(readFileSync(path, 'utf8'), readyCourse, name);
    return linked.length === 0 ? [brokenSource(handInName(name), unread('no-link').problem)] : linked;
  } catch (error) {
    return { problem: `${path}: ${reasonOf(error)}` };
  }
}

const tooLarge = (file: string, most: number): Source => brokenSource(file, unread('large', { file, most }).problem);

/** The files of a folder, and of its own folders. */
function filesIn(path: string): readonly TreeFile[] {
  return readdirSync(path, { withFileTypes: true }).flatMap(({ name }) => {
    const inside = join(path, name);
    if (!statSync(inside).isDirectory()) return [treeFile(inside, name)];
    const own = readdirSync(inside).filter((one) => statSync(join(inside, one)).isFile());
    // An empty one stays somebody's.
    return ['', ...own].map((one) => treeFile(join(inside, one), `${name}/${one}`));
  });
}

const treeFile = (from: string, path: string): TreeFile => ({
  path,
  read(maxBytes) {
    try {
      const status = statSync(from);
      if (!status.isFile()) return unread('kind');
      if (status.size > maxBytes) return unread('large', { file: basename(path), most: maxBytes });
      return { bytes: readFileSync(from) };
    } catch (error) {
      return unread('gone', { problem: reasonOf(error) });
    }
  },
});

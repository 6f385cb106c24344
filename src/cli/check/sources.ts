import { readdirSync, readFileSync, statSync } from 'node:fs';
import { basename, join } from 'node:path';
import {
  brokenSource,
  folderSources,
  linkSource,
  sourcesIn,
  withOwnNames,
  type Most,
  type Source,
  type TreeFile,
} from '#check/hand-in/sources';
import { unread } from '#check/hand-in/unread';
import { isAddress } from '../read-work';
import { readyCourse } from '../ready-courses';
import { reasonOf } from '../reason-of';

/** Chosen: fits in memory beside the runs. */
const MOST: Most = { zip: 500_000_000, list: 20_000_000 };

/**
 * Finds the hand-ins behind the words of the command line, in their order, those of a folder by their names: project files
 * and programs, folders and zips of them, files of links, links.
 *
 * @returns or what is wrong: a path that does not exist
 */
export async function findHandIns(
  paths: readonly string[],
): Promise<{ readonly sources: readonly Source[] } | { readonly problem: string }> {
  const found: Source[] = [];
  let isAny = false;
  for (const path of paths) {
    const here = isAddress(path) ? [linkSource({ name: '', address: path }, 0, readyCourse)] : await sourcesAt(path);
    if ('problem' in here) return here;
    isAny ||= here.length > 0;
    found.push(...(here.length > 0 ? here : [brokenSource(basename(path), unread('no-main').problem)]));
  }
  return { sources: isAny ? withOwnNames(found) : [] };
}

async function sourcesAt(path: string): Promise<readonly Source[] | { readonly problem: string }> {
  try {
    if (statSync(path).isDirectory()) return folderSources(filesIn(path), readyCourse);
    return await sourcesIn(treeFile(path, basename(path)), MOST, readyCourse);
  } catch (error) {
    return { problem: `${path}: ${reasonOf(error)}` };
  }
}

/** The files of a folder, and of its own folders. */
function filesIn(path: string): readonly TreeFile[] {
  return readdirSync(path, { withFileTypes: true }).flatMap(({ name }) => {
    const inside = join(path, name);
    if (!isFolder(inside)) return [treeFile(inside, name)];
    // An empty one stays somebody's.
    return ['', ...ownFiles(inside)].map((one) => treeFile(join(inside, one), `${name}/${one}`));
  });
}

/** What it has that is no folder; one that may not be opened has nothing. */
function ownFiles(path: string): readonly string[] {
  try {
    return readdirSync(path).filter((name) => !isFolder(join(path, name)));
  } catch {
    return [];
  }
}

/** A link that leads nowhere is none: whoever reads it says so. */
function isFolder(path: string): boolean {
  try {
    return statSync(path).isDirectory();
  } catch {
    return false;
  }
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

import { readdirSync, readFileSync, statSync } from 'node:fs';
import { basename, join, resolve } from 'node:path';
import { openGiven } from '#intake/file';
import { limits } from '#intake/formats';
import {
  brokenSource,
  givenFile,
  givenFolder,
  linkSource,
  together,
  withOwnNames,
  type Given,
  type Source,
} from '#intake/sources';
import type { TreeFile } from '#intake/tree';
import { unread } from '#check/hand-in/unread';
import { isLitter } from '#intake/zip';
import { isAddress } from '../read-work';
import { readyCourse } from '../ready-courses';
import { reasonOf } from '../reason-of';

/** Most levels of folders, and most files in all of them, that are searched. Chosen: more than any class has. */
const [MOST_DEPTH, MOST_FILES] = [20, 200_000];

/**
 * Finds the hand-ins behind the words of the command line, in their order, those of a folder by their names: project files
 * and programs, folders and zips of them, files of links, links.
 *
 * @returns also the files that they are read from; or what is wrong: a path that does not exist
 */
export async function findHandIns(
  paths: readonly string[],
): Promise<{ readonly sources: readonly Source[]; readonly files: readonly string[] } | { readonly problem: string }> {
  const all: Given[] = [];
  const files: string[] = [];
  for (const path of paths) {
    const here = isAddress(path) ? linkAt(path) : await givenAt(path, paths.length === 1);
    if ('problem' in here) return here;
    all.push(here);
    files.push(...here.files);
  }
  const isAny = all.some(({ sources }) => sources.length > 0);
  const nobody = (name: string): Source => brokenSource(name, unread('no-main').problem);
  const found = all.map((one) =>
    one.sources.length > 0 || !one.isTree ? one : { ...one, sources: [nobody(one.name)] },
  );
  return { sources: isAny ? withOwnNames(together(found)) : [], files };
}

/** Something given, and the files that it is read from. */
type FilesGiven = Given & { readonly files: readonly string[] };

/** Its name is the one inside the link. */
const linkAt = (address: string): FilesGiven => ({
  ...{ name: '', isTree: false, files: [] },
  sources: [linkSource({ name: '', address }, 0, readyCourse)],
});

async function givenAt(path: string, isAlone: boolean): Promise<FilesGiven | { readonly problem: string }> {
  const name = basename(resolve(path));
  try {
    if (statSync(path).isDirectory()) {
      const inside = filesIn(path);
      return { ...givenFolder(name, inside, readyCourse, isAlone), files: inside.map((file) => join(path, file.path)) };
    }
  } catch (error) {
    return { problem: `${path}: ${reasonOf(error)}` };
  }
  const opened = await openGiven(treeFile(path, name), limits.zipOnCommandLine);
  return { ...(await givenFile(opened, readyCourse, isAlone)), files: [path] };
}

/** All files of a folder, at any depth. An empty folder still counts as a hand-in. */
function filesIn(path: string): readonly TreeFile[] {
  const found: TreeFile[] = [];
  const names = (own: string): readonly string[] => {
    try {
      return readdirSync(join(path, own));
    } catch (error) {
      if (own === '') throw error;
      return []; // One that may not be opened has nothing.
    }
  };
  const look = (own: string, depth: number): void => {
    for (const name of names(own)) {
      if (isLitter(name) || found.length >= MOST_FILES) continue;
      const inside = `${own}${name}`;
      const isDeeper = isFolder(join(path, inside));
      found.push(treeFile(join(path, inside), isDeeper ? `${inside}/` : inside));
      // A link may lead back to a folder above.
      if (isDeeper && depth < MOST_DEPTH) look(`${inside}/`, depth + 1);
    }
  };
  look('', 0);
  return found;
}

/** True for a folder. A broken link is none: the code that reads it reports it. */
function isFolder(path: string): boolean {
  try {
    return statSync(path).isDirectory();
  } catch {
    return false;
  }
}

/** @param path its path in the folder that was given */
const treeFile = (from: string, path: string): TreeFile => ({
  path,
  size: sizeOf(from),
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

/** Size of a file; 0 if it does not exist: the code that reads it reports that. */
function sizeOf(path: string): number {
  try {
    return statSync(path).size;
  } catch {
    return 0;
  }
}

import type { Fields } from './reader';
import { SCENE_VERSION } from './scene';

/**
 * Steps that turn a file of version n into one of version n + 1; the first is for version 1. A step sees unchecked
 * data: it moves and renames values and leaves the validation to the reader.
 */
const steps: readonly ((file: Fields) => Fields)[] = [
  // 1 → 2: zones, spikes, movers, labels, colours, task and background are new; what there was means the same.
  (file) => file,
  // 2 → 3: what a task allows, its stars and its card are new; what there was means the same.
  (file) => file,
  // 3 → 4: starts of further robots, and how robots share a task, are new; what there was means the same.
  (file) => file,
  // 4 → 5: any angle, round bodies, polygons, locks, groups and more of what movers do are new. `turn` stays as it is: the
  // reader takes it, so that what is wrong with it is told in the words of the file.
  (file) => file,
  // 5 → 6: name and colour of the first robot are new; what there was means the same.
  (file) => file,
  // 6 → 7: heights of what stands on the floor are new; without them it is as high as it was.
  (file) => file,
  // 7 → 8: the colours and kinds of `news.ts` are new; what there was means the same.
  (file) => file,
];

/** The oldest version that is still read. */
export const OLDEST_VERSION = 1;

/**
 * A file of an older version as one of the newest.
 *
 * @param version the file's own, from `OLDEST_VERSION` to `SCENE_VERSION`
 */
export function migrated(file: Fields, version: number): Fields {
  const newest = steps.slice(version - OLDEST_VERSION).reduce((older, step) => step(older), file);
  return version === SCENE_VERSION ? file : { ...newest, version: SCENE_VERSION };
}

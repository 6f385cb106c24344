import type { PythonText } from '#python/tree';

/** Maximum depth of a syntax tree. Chosen: more than MicroPython's own parser takes on the device. */
const MOST_LEVELS = 400;

/** True if a program is nested too deeply to be legible: its tree is then not examined. */
export function isTooDeep({ tree }: PythonText): boolean {
  let level = 0;
  let deepest = 0;
  tree.iterate({
    enter: () => {
      level += 1;
      deepest = Math.max(deepest, level);
    },
    leave: () => {
      level -= 1;
    },
  });
  return deepest > MOST_LEVELS;
}

import type { Scene } from '#scene/scene';

/** Gives ids that no object of a course has and that were not given before: `wall-1`, `wall-2`, … */
export type IdSource = (prefix: string) => string;

/** Free ids for many objects at once; the same scene always gives the same ones in the same order as `freeId`. */
export function freeIds(scene: Scene): IdSource {
  const taken = new Set(scene.objects.map(({ id }) => id));
  const next = new Map<string, number>();
  return (prefix) => {
    for (let number = next.get(prefix) ?? 1; ; number += 1) {
      const id = `${prefix}-${number}`;
      if (taken.has(id)) continue;
      taken.add(id);
      next.set(prefix, number + 1);
      return id;
    }
  };
}

/** Gives names that no group of a course has and that were not given before: `group-1`, `group-2`, … */
export function freeGroups({ objects }: Scene): () => string {
  const taken = new Set(objects.map(({ group }) => group));
  let number = 0;
  return () => {
    do number += 1;
    while (taken.has(`group-${number}`));
    return `group-${number}`;
  };
}

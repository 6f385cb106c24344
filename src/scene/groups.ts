import type { Scene, SceneObject } from './scene';

/** The groups with a single object, which group nothing. */
export function loneGroups(objects: readonly SceneObject[]): ReadonlySet<string> {
  const [lone, all] = [new Set<string>(), new Set<string>()];
  for (const { group } of objects) {
    if (group === undefined) continue;
    if (all.has(group)) lone.delete(group);
    else lone.add(group);
    all.add(group);
  }
  return lone;
}

/** The objects without the names of groups of which only one object is left, for instance after the eraser. */
export function tidied(objects: readonly SceneObject[]): readonly SceneObject[] {
  const lone = loneGroups(objects);
  if (lone.size === 0) return objects;
  return objects.map((object) => {
    const { group, ...rest } = object;
    return group !== undefined && lone.has(group) ? rest : object;
  });
}

/** A course as its file and its link keep it: without groups of one. */
export const asKept = (scene: Scene): Scene => ({ ...scene, objects: tidied(scene.objects) });

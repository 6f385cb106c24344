import type { Project } from '#project/project';
import { tidied } from '#scene/groups';
import type { Scene, SceneObject } from '#scene/scene';
import { objectText, serializeScene } from '#scene/serialize';

import { memoOf } from '#core/memo';

/** A project as text for the browser's storage. It is saved while somebody types, so what has not changed is remembered. */
export const packedText = memoOf((project: Project): string => packed(project, sceneText(project.scene)));

/** The same, with the course's text given by the caller. */
export function packed({ files, scene: _, ...others }: Project, scene: string): string {
  const rest = JSON.stringify(others);
  return `{"files":${JSON.stringify(files)},"scene":${scene},${rest.slice(1)}`;
}

/** The course as text. Each object is written once: a course may have 20,000 points, and a stroke of the pen adds one object. */
export const sceneText = memoOf((scene: Scene): string => {
  const bare = compact(serializeScene({ ...scene, objects: [] }));
  return `${bare.slice(0, -'[]}'.length)}[${tidied(scene.objects).map(compactObject).join(',')}]}`;
});

const compactObject = memoOf((object: SceneObject): string => compact(objectText(object)));

const compact = (text: string): string => JSON.stringify(JSON.parse(text));

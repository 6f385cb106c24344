import { withoutSecrets } from '#check/task/write-task';
import type { Project } from '#project/project';
import type { SceneEdit } from '#scene/edit';
import { defaultScene } from '#scene/scene';

/** A change of the course. */
export const BLOCK: SceneEdit = {
  type: 'add',
  objects: [{ type: 'block', id: 'b', at: [100, 100], size: [50, 50], angle: 0 }],
};

/** A task as the class gets it: it asks for a loop, and locks this. */
export const givenTask = (text: string, locks: object, settings?: Project['settings']): Project =>
  withoutSecrets({
    files: [{ name: 'main.py', text }],
    ...{ scene: defaultScene(), course: null },
    ...(settings && { settings }),
    task: { version: 1, checks: [{ type: 'loop', id: 'loop' }], locks },
  });

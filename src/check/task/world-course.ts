import { editProblem } from '#scene/check-edit';
import { applyEdit } from '#scene/edit';
import type { Scene } from '#scene/scene';
import type { ClassTask, WorldVariant } from './task';

/** The course of a world, or why it cannot be made: a sentence that names the edit. */
export function courseOfWorld(
  course: Scene,
  { edits, start }: WorldVariant,
): { readonly scene: Scene } | { readonly problem: string } {
  let scene = course;
  for (const [index, edit] of edits.entries()) {
    const problem = editProblem(scene, edit);
    if (problem !== null) return { problem: `edits[${String(index)}]: ${problem.message}` };
    scene = applyEdit(scene, edit);
  }
  return { scene: start === null ? scene : { ...scene, robot: { ...scene.robot, ...start } } };
}

/** The courses in which work on a task may be done: the one that was set, and that of each of its worlds. */
export const coursesOf = ({ project: { scene }, worlds }: ClassTask): readonly Scene[] => [
  scene,
  ...worlds.flatMap((world) => {
    const course = courseOfWorld(scene, world);
    return 'scene' in course ? [course.scene] : [];
  }),
];

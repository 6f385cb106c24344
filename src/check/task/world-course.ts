import { editProblem } from '#scene/check-edit';
import { applyEdit } from '#scene/edit';
import type { Scene } from '#scene/scene';
import type { WorldVariant } from './task';

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

import { readyScene } from '../../session/work/catalogue/ready-courses';
import type { HandIn } from '#check/hand-in/hand-in';
import type { ClassTask } from '#check/task/task';
import { courseOfWorld } from '#check/task/world-course';
import { linkOf } from '#project/link/link';

/**
 * The address of the app with a hand-in in a world of the task: the pupil's programs on the teacher's course.
 *
 * @returns `null`: it would be too long
 */
export function runLink(task: ClassTask, handIn: HandIn, world: string): string | null {
  const variant = task.worlds.find(({ id }) => id === world) ?? task.worlds[0];
  const { project } = task;
  const course = courseOfWorld(project.scene, variant);
  const scene = 'scene' in course ? course.scene : project.scene;
  const made = linkOf({ ...project, files: handIn.project.files, scene }, { courses: readyScene, program: true });
  return made && `${location.origin}${location.pathname}#${made.fragment}`;
}

import { courseMark } from '../task/course-mark';
import type { ClassTask } from '../task/task';
import { coursesOf } from '../task/world-course';
import type { HandIn } from './hand-in';

/**
 * The name of the task that a hand-in was made for, if that is another one; `null`: it is this one, or unknown. An id
 * that both have decides, then the mark of the course that was handed out, then the ready course, then the course's
 * name.
 */
export function otherTask(task: ClassTask, { project, hasCourse, said, mark }: HandIn): string | null {
  const { id, project: own } = task;
  if (!hasCourse) return null;
  const theirs = said?.task ?? '';
  if (theirs !== '' && id !== '') return theirs === id ? null : theirs;
  const name = theirs || project.scene.name || (project.course ?? '?');
  if (mark !== undefined) return coursesOf(task).some((course) => courseMark(course) === mark) ? null : name;
  if (project.course !== null && own.course !== null) return project.course === own.course ? null : name;
  const areNamed = project.scene.name !== '' && own.scene.name !== '';
  return areNamed && project.scene.name !== own.scene.name ? name : null;
}

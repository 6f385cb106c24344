import { courseName } from './catalogue/first-course';
import type { WorkParts } from './model/parts';

/** What the present work is called where it is put aside: as the file that it came from, else as its course. */
export function workName({ work }: Pick<WorkParts, 'work'>): string {
  const { scene, course } = work.work.value.project;
  return work.cameFrom ?? courseName(scene, course);
}

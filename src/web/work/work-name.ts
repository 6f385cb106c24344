import { courseName } from './catalogue/first-course';
import type { WorkParts } from './model/parts';

/** What the present work is called where it is put aside. */
export function workName({ work }: Pick<WorkParts, 'work'>): string {
  const { scene, course } = work.work.value.project;
  return courseName(scene, course);
}

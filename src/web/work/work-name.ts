import { courseName } from './catalogue/first-course';
import type { App } from '../app/use-app';

/** What the present work is called where it is put aside. */
export function workName({ work }: Pick<App, 'work'>): string {
  const { scene, course } = work.work.value.project;
  return courseName(scene, course);
}

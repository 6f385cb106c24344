import { courseName } from './catalogue/first-course';
import type { WorkParts } from './model/parts';

/** Name of the present work when it is put aside. */
export function workName({ work }: { readonly work: Pick<WorkParts['work'], 'work'> }): string {
  const { scene, course } = work.work.value.project;
  return nameWithFile(courseName(scene, course), work.work.value.file);
}

/** The name of a work after that of its file: a teacher opens many files of one course. */
export const nameWithFile = (name: string, file: string | undefined): string =>
  file === undefined || file === name ? name : `${file} – ${name}`;

/** The name to save the present work under: that of the file it came from, else that of its course. */
export function nameToSave({ work }: Pick<WorkParts, 'work'>): string {
  const { project, file } = work.work.value;
  return file ?? courseName(project.scene, project.course);
}

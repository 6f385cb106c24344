import { defaultProjectSettings, MAIN, newWork, type Project } from '#project/project';
import type { Course } from './course';
import { courses } from './courses';
import { missions } from './missions';

/** The ready course or mission with that id; `null`: none. */
export const readyCourseOf = (id: string | null): Course | null =>
  [...courses, ...missions].find((course) => course.id === id) ?? null;

/**
 * A ready course as a task for a class, with the settings of new work, as pupils have it. One that is opened with its
 * solution hands nothing out: finding the solution is the work.
 */
export const withStart = (project: Project, course: Course): Project =>
  Object.values(course.solution).includes(project.files[0]?.text ?? '')
    ? asNew({ ...project, files: [{ name: MAIN, text: '' }] })
    : asNew(project);

/** A project that is begun now. */
export const asNew = (project: Project): Project => ({
  ...project,
  settings: { ...defaultProjectSettings, ...newWork },
});

/**
 * The start program of a task as pupils may have found it: in every language, if the task's is that of its ready course in
 * one of them; else none but its own.
 */
export function startsOf({ course: id, files: [main, ...others] }: Project): readonly string[] {
  const programs = Object.values(readyCourseOf(id)?.program ?? {});
  return main !== undefined && others.length === 0 && programs.includes(main.text) ? programs : [];
}

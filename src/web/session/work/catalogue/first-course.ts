import { MAIN, type Project } from '#project/project';
import type { Scene } from '#scene/scene';

import { shownLanguage, t } from '../../../kit/i18n';
import type { Course } from '#catalogue/course';
import { knownCourses } from './known-courses';
import { missionsOf, type MissionFiles } from '#catalogue/mission';

// Only what a first visit shows comes with the page; the other courses lie in ready-courses.ts, which is fetched late.
const files: MissionFiles = {
  scenes: import.meta.glob('../../../../../courses/missions/01-forward/scene.json', {
    query: '?scene',
    import: 'default',
    eager: true,
  }),
  data: import.meta.glob('../../../../../courses/missions/01-forward/mission.json', {
    query: '?raw',
    import: 'default',
    eager: true,
  }),
  main: import.meta.glob('../../../../../courses/missions/01-forward/main.py', {
    query: '?languages',
    import: 'default',
    eager: true,
  }),
  start: import.meta.glob('../../../../../courses/missions/01-forward/start.py', {
    query: '?languages',
    import: 'source',
    eager: true,
  }),
};

/** The course of a first visit: the first mission, for the first robot. */
export const firstCourse: Course | undefined = missionsOf(files)[0];

/** Fetches the names of all courses where one is open that did not come with the page. */
export async function fetchNameOf(id: string | null): Promise<void> {
  if (id !== null && id !== firstCourse?.id && knownCourses.value === null) await import('./ready-courses');
}

/** A course's name: in the chosen language if we know it, else that in its file. */
export function courseName(scene: Scene, id: string | null): string {
  const course = (knownCourses.value ?? [firstCourse]).find((one) => one?.id === id);
  return course?.texts[shownLanguage()].name ?? (scene.name || t('course.unnamed'));
}

/** True if the files are just as a first visit finds them, in whatever language. */
export function isAsFound({ files: [main, ...others] }: Project): boolean {
  return main?.name === MAIN && others.length === 0 && isFirstProgram(main.text);
}
const isFirstProgram = (text: string): boolean =>
  firstCourse !== undefined && Object.values(firstCourse.program).includes(text);

import type { Course } from './course';
import { courses } from './courses';
import { knownCourses } from './known-courses';
import { missions } from './missions';

/** All courses that come with the page: those of the gallery and the missions. */
export const readyCourses: readonly Course[] = [...courses, ...missions];
knownCourses.value = readyCourses;

/** The ready course of that name. */
export const readyCourse = (id: string): Course | null => readyCourses.find((course) => course.id === id) ?? null;

import type { Course } from '#catalogue/course';
import { courses } from '#catalogue/courses';
import { knownCourses } from './known-courses';
import { missions } from '#catalogue/missions';

/** All courses that come with the page: those of the gallery and the missions. */
export const readyCourses: readonly Course[] = [...courses, ...missions];
knownCourses.value = readyCourses;

/** The ready course of that name. */
export const readyCourse = (id: string): Course | null => readyCourses.find((course) => course.id === id) ?? null;

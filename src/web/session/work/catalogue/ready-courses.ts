import type { Course } from '#catalogue/course';
import { courses } from '#catalogue/courses';
import { knownCourses } from './known-courses';
import { missions } from '#catalogue/missions';
import type { Scene } from '#scene/scene';

/** All courses that come with the page: those of the gallery and the missions. */
export const readyCourses: readonly Course[] = [...courses, ...missions];
knownCourses.set(readyCourses);

/** The ready course of that name. */
export const readyCourse = (id: string): Course | null => readyCourses.find((course) => course.id === id) ?? null;

/** The scene of the ready course of that name; links name it, too. */
export const readyScene = (id: string): Scene | null => readyCourse(id)?.scene ?? null;

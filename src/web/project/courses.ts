/**
 * The ready courses. Each is a folder in `courses/`, and everything about it is in there:
 *
 * - `scene.json`: the arena, and where the robot starts (`#scene/scene`). `name` and `description` are for whoever
 *   opens the file elsewhere; `robot.type` and `robot.options` name the robot where the program's imports do not.
 * - `main.py`, or `main.de.py` and `main.en.py`: the program that solves it. With one of them the same in all languages;
 *   with two they differ in comments and shown words only.
 * - `texts.json`: `{ "place": 4, "de": { "name": "…", "text": "…" }, "en": { "name": "…", "text": "…" } }`: its place in
 *   the list (lowest first), what it is called, and one or two sentences on what it is about.
 * - `expected.csv`: the trace of its run (`courses/golden.json`).
 *
 * Fetched late, with the list. `first-course.ts` holds the one that comes with the page.
 */
import { shownLanguage } from '../i18n';
import { coursesOf, type Course } from './course';
import { knownCourses } from './known-courses';

const files = import.meta.glob<string>('../../../courses/*/{scene.json,texts.json,main.py,main.de.py,main.en.py}', {
  query: '?raw',
  import: 'default',
  eager: true,
});

/** All ready courses, in the order of the list. */
export const courses: readonly Course[] = coursesOf(files);
knownCourses.value = courses;

/** What a course says about itself, in the chosen language. */
export function courseText(course: Course): string {
  return course.texts[shownLanguage()].text;
}

/**
 * The ready courses. Each is a folder in `courses/`, and everything about it is in there:
 *
 * - `scene.json`: the arena, and where the robot starts (`#scene/scene`). `name` and `description` are for whoever
 *   opens the file elsewhere; `robot.type` and `robot.options` name the robot where the program's imports do not.
 * - `main.py`, or one for each language, `main.de.py`, `main.fr.py` …: the program that solves it. They differ in
 *   comments and shown words only.
 * - `start.py`, or `start.de.py`, `start.fr.py` …: what the pupil finds on opening it, a beginning that runs and leaves
 *   the task to them. Without it they find the solution.
 * - `texts.json`: `{ "place": 4, "level": 2, "kind": "line", "de": { "name": "…", "text": "…", "task": "…" }, "fr": … }`:
 *   its place in the list (lowest first), how hard it is (1 … 3), what it is about (`courseKinds`), what it is called, one
 *   or two sentences on it, and what is to be done.
 * - `expected.csv`: the trace of its run (`courses/golden.json`).
 *
 * Fetched late, with the list. `first-course.ts` holds the one that comes with the page.
 */
import { shownLanguage } from '../../page/i18n';
import { coursesOf, type Course } from './course';
import { knownCourses } from './known-courses';

const files = import.meta.glob<string>('../../../../courses/*/{scene.json,texts.json,main*.py,start*.py}', {
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

/** What a course asks for, in the chosen language. */
export function courseTask(course: Course): string {
  return course.texts[shownLanguage()].task;
}

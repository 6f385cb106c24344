/**
 * The courses of the gallery. Each is a folder in `courses/` with everything about it:
 *
 * - `scene.json`: the arena, and where the robot starts (`#scene/scene`). `name` and `description` are for those who
 *   open the file elsewhere; `robot.type` and `robot.options` name the robot where the program's imports do not.
 * - `main.py`: the program that solves it, in English.
 * - `start.py`: the program on opening it, a beginning that runs and leaves the task to the pupil. Without it the
 *   solution is shown.
 * - `course.json`: `{ "place": 4, "level": 2, "kind": "line" }`: its place in the list (lowest first), how hard it is
 *   (1 … 3), what it is about (`courseKinds`). With several devices also
 *   `"devices": [{ "name": "robot", "robot": "auto" }, { "name": "remote", "robot": "none" }]`, the first one with `main.py` and `start.py`.
 * - `remote.py`, `remote-start.py`: the same for a further device called so. The texts of that name are its name.
 * - `inputs.json`: button presses and tilts while its solution is recorded, if it needs any.
 * - `words/de.json`, `words/fr.json` …: `{ "name": "…", "text": "…", "task": "…", "program": { … } }`: its name, one
 *   or two sentences on it, its task, and the comments and strings of its programs (`build/programs.ts`).
 *
 * The drive of its solution is recorded in `courses/golden.json`.
 *
 * The page loads this on demand, with the list.
 */
import type { Course } from './course';
import { coursesOf, type CourseFiles } from './read-courses';

const files: CourseFiles = {
  scenes: import.meta.glob('../../courses/*/scene.json', { query: '?scene', import: 'default', eager: true }),
  data: import.meta.glob('../../courses/*/course.json', { query: '?raw', import: 'default', eager: true }),
  main: import.meta.glob('../../courses/*/main.py', { query: '?languages', import: 'default', eager: true }),
  start: import.meta.glob('../../courses/*/start.py', { query: '?languages', import: 'source', eager: true }),
  others: import.meta.glob(['../../courses/*/*.py', '!**/{main,start}.py', '!**/{board,golden}/**'], {
    query: '?languages',
    import: 'source',
    eager: true,
  }),
};

/** The courses of the gallery, in its order. */
export const courses: readonly Course[] = coursesOf(files);

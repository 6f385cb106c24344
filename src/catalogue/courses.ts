/**
 * The courses of the gallery. Each is a folder in `courses/`, and everything about it is in there:
 *
 * - `scene.json`: the arena, and where the robot starts (`#scene/scene`). `name` and `description` are for whoever
 *   opens the file elsewhere; `robot.type` and `robot.options` name the robot where the program's imports do not.
 * - `main.py`: the program that solves it, in English.
 * - `start.py`: what the pupil finds on opening it, a beginning that runs and leaves the task to them. Without it they
 *   find the solution.
 * - `course.json`: `{ "place": 4, "level": 2, "kind": "line" }`: its place in the list (lowest first), how hard it is
 *   (1 … 3), what it is about (`courseKinds`). With several devices also
 *   `"devices": [{ "name": "robot", "robot": "auto" }, { "name": "remote", "robot": "none" }]`, the first one with `main.py` and `start.py`.
 * - `remote.py`, `remote-start.py`: the same for a further device called so. The words of that name are its name.
 * - `inputs.json`: what is pressed and tilted while its solution is recorded, where that needs somebody.
 * - `words/de.json`, `words/fr.json` …: `{ "name": "…", "text": "…", "task": "…", "program": { … } }`: what it is called, one
 *   or two sentences on it, what is to be done, and the comments and strings of its programs (`build/programs.ts`).
 *
 * How its solution drives is recorded in `courses/golden.json`.
 *
 * On the page fetched late, with the list.
 */
import { coursesOf, type Course, type CourseFiles } from './course';

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

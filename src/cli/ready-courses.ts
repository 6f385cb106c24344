import { projectOf } from '#catalogue/course';
import { courses as courseList } from '#catalogue/courses';
import { missions } from '#catalogue/missions';
import { asNew, readyCourseOf } from '#catalogue/starts';
import type { Language } from '#core/languages';
import { parseSceneValue } from '#scene/parse';
import type { Scene } from '#scene/scene';
import { anyHardware, MAIN, type FurtherDevice, type Project } from '#project/project';
import { parseInputs } from '#simulation/input-file';
import type { InputEvent } from '#simulation/input';
import { nearest } from './commands/nearest';

const scenes = import.meta.glob<unknown>('../../courses/*/scene.json', { eager: true, import: 'default' });
const courses = import.meta.glob<CourseData>('../../courses/*/course.json', { eager: true, import: 'default' });
const programs = import.meta.glob<string>('../../courses/*/*.py', { eager: true, import: 'default', query: '?raw' });
const inputs = import.meta.glob<string>('../../courses/*/inputs.json', {
  eager: true,
  import: 'default',
  query: '?raw',
});

/** The devices in `course.json`, for a course that has several. */
interface CourseData {
  readonly devices?: readonly { readonly name: string; readonly robot: string }[];
}

/** The ready course or mission with this id, which a link only names; `null` if there is none. */
export function readyCourse(id: string): Scene | null {
  const value = scenes[`../../courses/${id}/scene.json`];
  if (value === undefined) return readyCourseOf(id)?.scene ?? null;
  const parsed = parseSceneValue(value);
  return 'scene' in parsed ? parsed.scene : null;
}

/** The ids of all ready courses and missions, in the page's order. */
export const readyIds = (): readonly string[] => [...courseList, ...missions].map(({ id }) => id);

/** The problem with a word that is no ready course, with the one that was probably meant; `null`: it is no id at all. */
export function noReadyCourse(word: string): string | null {
  if (!/^[\w-]+$/.test(word)) return null;
  const meant = nearest(word, readyIds());
  return `There is no ready course "${word}" either.${meant === null ? '' : ` Did you mean ${meant}?`}`;
}

/** The page's title of a ready course in this language; `null`: that of its scene. */
export const readyTitle = (id: string | null, language: Language): string | null =>
  readyCourseOf(id)?.texts[language].name ?? null;

/**
 * The ready course or mission with this id as a task for a class: its start program and its inputs; `null` if there
 * is none. Its further devices have their programs, for hand-ins of the first one's program alone.
 */
export function readyProject(id: string): Project | null {
  const scene = readyCourse(id);
  if (scene === null) return null;
  const ready = readyCourseOf(id);
  if (ready?.mission !== undefined) return asNew(projectOf(ready, 'en'));
  const programOf = (name: string): string => programs[`../../courses/${id}/${name}.py`] ?? '';
  const [first, ...others] = courses[`../../courses/${id}/course.json`]?.devices ?? [];
  const further = others.map(({ name, robot }): FurtherDevice => {
    return { ...anyHardware, name, robot, files: [{ name: MAIN, text: programOf(name) }], sameAs: '' };
  });
  const pressed = inputsOf(id);
  return asNew({
    files: [{ name: MAIN, text: programOf('start') }],
    scene,
    course: id,
    ...(first !== undefined && { devices: { first: first.name, others: further } }),
    ...(pressed.length > 0 && { task: { version: 1, worlds: [{ id: 'visible', hidden: false, inputs: pressed }] } }),
  });
}

function inputsOf(id: string): readonly InputEvent[] {
  const text = inputs[`../../courses/${id}/inputs.json`];
  const parsed = text === undefined ? { inputs: [] } : parseInputs(text);
  return 'inputs' in parsed ? parsed.inputs : [];
}

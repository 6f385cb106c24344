import type { Language, Texts } from '#core/languages';
import { inEvery } from '#core/words';
import type { Scene } from '#scene/scene';

import type { Course, CourseDevice, CourseTexts } from './course';

/** A program in every language, and the texts about its course. */
export interface ProgramWords {
  readonly source: Texts;
  readonly name?: Texts;
  readonly text?: Texts;
  readonly task?: Texts;
  readonly hints?: Readonly<Record<Language, readonly string[]>>;
}

/** The files of some courses, by their paths. */
export interface CourseFiles {
  /** `scene.json`, read. */
  readonly scenes: Readonly<Record<string, Scene>>;
  /** `course.json`. */
  readonly data: Readonly<Record<string, string>>;
  /** `main.py`, with the texts about the course; those it lacks are the scene's name and description. */
  readonly main: Readonly<Record<string, ProgramWords>>;
  /** `start.py`. */
  readonly start: Readonly<Record<string, Texts>>;
  /** The programs of further devices: `NAME.py`, which solves it, and `NAME-start.py`. */
  readonly others?: Readonly<Record<string, Texts>>;
}

/** The courses in these files, in the order of the list. */
export function coursesOf(files: CourseFiles): Course[] {
  return Object.keys(files.main)
    .flatMap((path) => readCourse(path.replace('/main.py', ''), files))
    .sort((one, other) => (one.place ?? Infinity) - (other.place ?? Infinity) || (one.id < other.id ? -1 : 1));
}

function readCourse(folder: string, { scenes, data, main, start, others }: CourseFiles): Course[] {
  const scene = scenes[`${folder}/scene.json`];
  const words = main[`${folder}/main.py`];
  if (scene === undefined || words === undefined) return [];
  const {
    place = null,
    level = 1,
    kind = 'free',
    devices = [],
  } = JSON.parse(data[`${folder}/course.json`] ?? '{}') as CourseData;
  const texts = inEvery<CourseTexts>((language) => ({
    name: words.name?.[language] ?? scene.name,
    text: words.text?.[language] ?? scene.description,
    task: words.task?.[language] ?? scene.description,
    ...(words.hints === undefined ? {} : { hints: words.hints[language] }),
  }));
  const program = start[`${folder}/start.py`] ?? words.source;
  const id = folder.replace(/^.*\//, '');
  const solution = words.source;
  const all = devices.map(({ name, robot }, at): CourseDevice => {
    const own = others?.[`${folder}/${name}.py`] ?? solution;
    const begins = others?.[`${folder}/${name}-start.py`] ?? own;
    const called = (words as unknown as Readonly<Record<string, Texts>>)[name] ?? inEvery(() => name);
    return at === 0
      ? { name: called, robot, program, solution }
      : { name: called, robot, program: begins, solution: own };
  });
  return [{ id, place, level, kind, scene, program, solution, texts, devices: all, isRandom: false }];
}

/** Contents of `course.json`. */
type CourseData = Partial<Pick<Course, 'place' | 'level' | 'kind'>> & {
  readonly devices?: readonly { readonly name: string; readonly robot: string }[];
};

/** The course as it is opened with its solution. */
export const withSolution = (course: Course): Course => ({
  ...course,
  program: course.solution,
  devices: course.devices.map((device) => ({ ...device, program: device.solution })),
});

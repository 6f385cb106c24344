import type { Language, Texts } from '#core/languages';
import { inEvery } from '#core/words';
import { anyHardware, MAIN, type Project } from '#project/project';
import type { Scene } from '#scene/scene';

import type { Mission } from './mission-place';

/** A ready course: an arena with a task, and programs that drive in it. How its folder looks: see `courses.ts`. */
export interface Course {
  /** Name of its folder. */
  readonly id: string;
  /** Place in the list, lowest first; `null`: at the end. */
  readonly place: number | null;
  readonly level: CourseLevel;
  readonly kind: CourseKind;
  readonly scene: Scene;
  /** The initial program of a course: a beginning, or without one the solution. By the language of its words. */
  readonly program: Readonly<Record<Language, string>>;
  /** The program that does what the course asks for. */
  readonly solution: Readonly<Record<Language, string>>;
  readonly texts: Readonly<Record<Language, CourseTexts>>;
  /** Its devices, the first one with the course's robot and programs; empty: there is one. */
  readonly devices: readonly CourseDevice[];
  /** Made from a number, without a folder: the user works on a course of their own. */
  readonly isRandom: boolean;
  /** Its place on the ladder of missions, where it belongs to it. */
  readonly mission?: Mission;
}

/** A device of a course that has several. */
export interface CourseDevice {
  readonly name: Texts;
  /** Id of its robot, `none` for a board in the hand, or `auto`. */
  readonly robot: string;
  readonly program: Texts;
  readonly solution: Texts;
}

/** Difficulty of a course: 1 easy, 2 medium, 3 hard. */
export type CourseLevel = 1 | 2 | 3;

/** Topics of courses, in the order of the gallery. */
export const courseKinds = ['free', 'line', 'drive', 'obstacles', 'maze', 'blocks'] as const;
export type CourseKind = (typeof courseKinds)[number];

/** Texts of a course: its name, its description and its task. */
export interface CourseTexts {
  readonly name: string;
  /** One or two sentences on what it is about. */
  readonly text: string;
  /** The pupil's task. */
  readonly task: string;
  /** Opened one by one, the gentlest first. */
  readonly hints?: readonly string[];
}

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

/** A course as something to work on. */
export function projectOf(course: Course, language: Language): Project {
  const files = [{ name: MAIN, text: course.program[language] }];
  const [first, ...others] = course.devices.map(({ name, robot, program }) => ({
    ...{ ...anyHardware, robot, name: name[language], sameAs: '' },
    files: [{ name: MAIN, text: program[language] }],
  }));
  const devices = first && { first: first.name, others };
  return { files, scene: course.scene, course: course.isRandom ? null : course.id, ...(devices && { devices }) };
}

/** The course as it is opened with its solution. */
export const withSolution = (course: Course): Course => ({
  ...course,
  program: course.solution,
  devices: course.devices.map((device) => ({ ...device, program: device.solution })),
});

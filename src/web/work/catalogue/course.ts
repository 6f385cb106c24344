import type { Language, Texts } from '#core/languages';
import { inEvery } from '#core/words';
import { MAIN, type Project } from '#project/project';
import { parseScene } from '#scene/parse';
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
  /** Made from a number, without a folder: the user works on a course of their own. */
  readonly isRandom: boolean;
  /** Its place on the ladder of missions, where it belongs to it. */
  readonly mission?: Mission;
}

/** How hard a course is: 1 easy, 2 medium, 3 hard. */
export type CourseLevel = 1 | 2 | 3;

/** What courses are about, in the order of the gallery. */
export const courseKinds = ['free', 'line', 'drive', 'obstacles', 'maze', 'blocks'] as const;
export type CourseKind = (typeof courseKinds)[number];

/** What a course is called, what it says about itself, and what it asks for. */
export interface CourseTexts {
  readonly name: string;
  /** One or two sentences on what it is about. */
  readonly text: string;
  /** What the pupil is to do. */
  readonly task: string;
  /** Opened one by one, the gentlest first. */
  readonly hints?: readonly string[];
}

/** A program in every language, and the texts about its course. */
export interface ProgramWords extends Partial<Record<'name' | 'text' | 'task', Texts>> {
  readonly source: Texts;
  readonly hints?: Readonly<Record<Language, readonly string[]>>;
}

/** The files of some courses, by their paths. */
export interface CourseFiles {
  /** `scene.json` and `course.json`. */
  readonly data: Readonly<Record<string, string>>;
  /** `main.py`, with the texts about the course; where it says nothing, the scene's name and description stand in. */
  readonly main: Readonly<Record<string, ProgramWords>>;
  /** `start.py`. */
  readonly start: Readonly<Record<string, Texts>>;
}

/** The courses in these files, in the order of the list. */
export function coursesOf(files: CourseFiles): Course[] {
  return Object.keys(files.main)
    .flatMap((path) => readCourse(path.replace('/main.py', ''), files))
    .sort((one, other) => (one.place ?? Infinity) - (other.place ?? Infinity) || one.id.localeCompare(other.id, 'en'));
}

function readCourse(folder: string, { data, main, start }: CourseFiles): Course[] {
  const parsed = parseScene(data[`${folder}/scene.json`] ?? '');
  const words = main[`${folder}/main.py`];
  if (!('scene' in parsed) || words === undefined) return [];
  const { scene } = parsed;
  const {
    place = null,
    level = 1,
    kind = 'free',
  } = JSON.parse(data[`${folder}/course.json`] ?? '{}') as Partial<Course>;
  const texts = inEvery<CourseTexts>((language) => ({
    name: words.name?.[language] ?? scene.name,
    text: words.text?.[language] ?? scene.description,
    task: words.task?.[language] ?? scene.description,
    ...(words.hints === undefined ? {} : { hints: words.hints[language] }),
  }));
  const program = start[`${folder}/start.py`] ?? words.source;
  const id = folder.replace(/^.*\//, '');
  return [{ id, place, level, kind, scene, program, solution: words.source, texts, isRandom: false }];
}

/** A course as something to work on. */
export function projectOf(course: Course, language: Language): Project {
  const files = [{ name: MAIN, text: course.program[language] }];
  return { files, scene: course.scene, course: course.isRandom ? null : course.id };
}

/** The course as it is opened with its solution. */
export const solved = (course: Course): Course => ({ ...course, program: course.solution });

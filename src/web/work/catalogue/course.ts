import { MAIN, type Project } from '#project/project';
import { parseScene } from '#scene/parse';
import type { Scene } from '#scene/scene';

import { LANGUAGES, type Language } from '../../page/i18n/texts';

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
}

/**
 * The courses in these files, in the order of the list.
 *
 * @param files path → text; the last two parts of a path are the course's folder and the file
 */
export function coursesOf(files: Readonly<Record<string, string>>): Course[] {
  const folders = new Map<string, Map<string, string>>();
  for (const [path, text] of Object.entries(files)) {
    const [folder = '', file = ''] = path.split('/').slice(-2);
    folders.set(folder, (folders.get(folder) ?? new Map<string, string>()).set(file, text));
  }
  return [...folders]
    .flatMap(([id, own]) => readCourse(id, own))
    .sort((one, other) => (one.place ?? Infinity) - (other.place ?? Infinity) || one.id.localeCompare(other.id, 'en'));
}

function readCourse(id: string, files: ReadonlyMap<string, string>): Course[] {
  const parsed = parseScene(files.get('scene.json') ?? '');
  if (!('scene' in parsed)) return [];
  const { scene } = parsed;
  const words = JSON.parse(files.get('texts.json') ?? '{}') as FolderTexts;
  const file = (stem: string, language: Language): string | undefined =>
    files.get(`${stem}.${language}.py`) ?? files.get(`${stem}.py`) ?? files.get(`${stem}.en.py`);
  const solution = inEach((language) => file('main', language) ?? '');
  const program = inEach((language) => file('start', language) ?? solution[language]);
  const spoken: CourseTexts = { name: scene.name, text: scene.description, task: scene.description };
  const texts = inEach((language) => ({ ...spoken, ...words[language] }));
  const { place = null, level = 1, kind = 'free' } = words;
  return [{ id, place, level, kind, scene, program, solution, texts, isRandom: false }];
}

/** The content of `texts.json`. */
type FolderTexts = Partial<Pick<Course, 'place' | 'level' | 'kind'> & Record<Language, CourseTexts>>;

const inEach = <T>(make: (language: Language) => T): Readonly<Record<Language, T>> =>
  Object.fromEntries(LANGUAGES.map((language) => [language, make(language)])) as Record<Language, T>;

/** A course as something to work on. */
export function projectOf(course: Course, language: Language): Project {
  const files = [{ name: MAIN, text: course.program[language] }];
  return { files, scene: course.scene, course: course.isRandom ? null : course.id };
}

/** The course as it is opened with its solution. */
export const solved = (course: Course): Course => ({ ...course, program: course.solution });

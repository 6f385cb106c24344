import { parseScene } from '#scene/parse';
import type { Scene } from '#scene/scene';

import { LANGUAGES, type Language } from '../i18n/texts';
import { MAIN, type Project } from './project';

/** A ready course: an arena and a program that drives in it. How its folder looks: see `courses.ts`. */
export interface Course {
  /** Name of its folder. */
  readonly id: string;
  /** Place in the list, lowest first; `null`: at the end. */
  readonly place: number | null;
  readonly scene: Scene;
  /** `main.py`, by the language of its comments and words. */
  readonly program: Readonly<Record<Language, string>>;
  readonly texts: Readonly<Record<Language, CourseTexts>>;
}

/** What a course is called, and what it says about itself. */
export interface CourseTexts {
  readonly name: string;
  readonly text: string;
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
  const words = JSON.parse(files.get('texts.json') ?? '{}') as { place?: number } & Partial<Course['texts']>;
  const program = (language: Language): string => files.get(`main.${language}.py`) ?? files.get(MAIN) ?? '';
  const texts = (language: Language): CourseTexts => words[language] ?? { name: scene.name, text: scene.description };
  return [{ id, place: words.place ?? null, scene, program: inEach(program), texts: inEach(texts) }];
}

const inEach = <T>(make: (language: Language) => T): Readonly<Record<Language, T>> =>
  Object.fromEntries(LANGUAGES.map((language) => [language, make(language)])) as Record<Language, T>;

/** A course as something to work on. */
export function projectOf(course: Course, language: Language): Project {
  return { files: [{ name: MAIN, text: course.program[language] }], scene: course.scene, course: course.id };
}

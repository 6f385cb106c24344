import { robotTypes } from '#robots/index';
import type { RobotExample } from '#robots/robot';
import { parseScene } from '#scene/parse';
import type { Scene } from '#scene/scene';

import { t } from '../i18n';
import type { TextKey } from '../i18n/texts';
import { MAIN, type Project } from './project';

/** A ready course: an arena and a program that drives in it. */
export interface Course {
  /** Name of its folder. */
  readonly id: string;
  readonly scene: Scene;
  readonly program: string;
}

const scenes = import.meta.glob<string>('../../../courses/*/scene.json', {
  query: '?raw',
  import: 'default',
  eager: true,
});
const programs = import.meta.glob<string>('../../../courses/*/main.py', {
  query: '?raw',
  import: 'default',
  eager: true,
});

/** The course a first visit opens. */
const FIRST = 'line';

/** All ready courses, the smallest arena text first: the empty one, then the fuller ones. */
export const courses: readonly Course[] = Object.entries(scenes)
  .flatMap(([path, text]) => readCourse(path, text))
  .sort((one, other) => one.scene.objects.length - other.scene.objects.length);

function readCourse(path: string, text: string): Course[] {
  const id = path.split('/').at(-2) ?? '';
  const parsed = parseScene(text);
  return 'scene' in parsed
    ? [{ id, scene: parsed.scene, program: programs[path.replace('scene.json', MAIN)] ?? '' }]
    : [];
}

/** A course as something to work on. */
export function projectOf(course: Course): Project {
  return { files: [{ name: MAIN, text: course.program }], scene: course.scene, course: course.id };
}

/** What a first visit shows. */
export function firstCourse(): Course | undefined {
  return courses.find((course) => course.id.includes(FIRST)) ?? courses[0];
}

/** Sample programs of the robots, for any arena. */
export const examples: readonly RobotExample[] = robotTypes.flatMap((type) => type.examples);

/** The files are just as some course or example brought them: nothing of the pupil's own is in them. */
export function isUntouched(project: Project): boolean {
  const [main, ...others] = project.files;
  if (others.length > 0 || main === undefined) return false;
  const brought = [...courses.map(({ program }) => program), ...examples.map(({ source }) => source)];
  return main.text.trim() === '' || brought.includes(main.text);
}

/** Our own courses' texts in all languages; other courses speak as their file does. */
const TEXTS = new Map<string | null, { readonly name: TextKey; readonly text: TextKey }>([
  ['empty', { name: 'ready.emptyName', text: 'ready.emptyText' }],
  ['closed-line', { name: 'ready.lineName', text: 'ready.lineText' }],
  ['small-maze', { name: 'ready.mazeName', text: 'ready.mazeText' }],
]);

/** What a course is called, in the chosen language where we know it. */
export function courseName(scene: Scene, id: string | null): string {
  const texts = TEXTS.get(id);
  return texts === undefined ? scene.name || t('course.unnamed') : t(texts.name);
}

/** What a course says about itself, likewise. */
export function courseText({ id, scene }: Course): string {
  const texts = TEXTS.get(id);
  return texts === undefined ? scene.description : t(texts.text);
}

/**
 * The properties and kinds of a course that are new in version 8 of its file and version 11 of links. All of them are said
 * here: what has none of them is written as before, letter by letter.
 */
import { isFirstColor } from './paint/paint';
import type { Scene, SceneObject } from './scene';

/** The kinds of objects that no course file before version 8 can hold. */
const newKinds = ['paper', 'lamp', 'barrier', 'tunnel', 'tag'] as const satisfies readonly SceneObject['type'][];

/** An object of a new kind. */
export type NewObject = Extract<SceneObject, { readonly type: (typeof newKinds)[number] }>;

/** The new properties of objects; a colour of strokes only if it is a new one. */
const newProperties: readonly string[] = ['color', 'infrared', 'blockColor', 'mass', 'friction', 'rolls'];

/** The kinds of older objects that may have new properties. */
const changedKinds: readonly SceneObject['type'][] = [
  ...(['stroke', 'target', 'checkpoint', 'forbidden'] as const),
  ...(['wall', 'block', 'fixed-block'] as const),
];

/** The new properties of the course as a whole. */
const newCourseProperties: readonly (keyof Scene)[] = ['league', 'ambient'];

/** True if an object is of a new kind. */
export const isNewKind = (object: SceneObject): object is NewObject => newKinds.some((kind) => kind === object.type);

/** The new properties that an object of an older kind has, by their names. */
export function newsOf(object: SceneObject): Readonly<Record<string, unknown>> {
  if (!changedKinds.includes(object.type)) return {};
  const isOld = object.type === 'stroke' && isFirstColor(object.color);
  return said(object, isOld ? newProperties.filter((name) => name !== 'color') : newProperties);
}

/** The new properties that a course as a whole has. */
export const courseNewsOf = (scene: Scene): Readonly<Record<string, unknown>> => said(scene, newCourseProperties);

const said = (of: object, names: readonly string[]): Readonly<Record<string, unknown>> =>
  Object.fromEntries(Object.entries(of).filter(([name, value]) => value !== undefined && names.includes(name)));

/** True if a course holds something that only the newest version of its file can say. */
export const hasNews = (scene: Scene): boolean =>
  Object.keys(courseNewsOf(scene)).length > 0 ||
  scene.objects.some((object) => isNewKind(object) || Object.keys(newsOf(object)).length > 0);

import { isRecord } from '#core/record';
import { courseNewsOf, isNewKind, newsOf } from '#scene/news';
import type { Scene, SceneObject } from '#scene/scene';

/**
 * The additions of link version 11 to a course (`#scene/news`), as JSON, checked like a file's once it is put together:
 *
 *     {"objects": [[step, {…}], …], "course": {…}}
 *
 * A place is a step from the one before, so that things in a row repeat. An entry of an older kind has its new properties, one of a new kind all of them; both parts are left out if empty. Empty
 * text: there is nothing new. It is text and no columns, so that what is still to come needs no version of its own.
 */
export function newsTextOf(scene: Scene, objects: readonly SceneObject[]): string {
  let before = 0;
  const entries = objects.flatMap((object, place) => {
    const said = isNewKind(object) ? object : newsOf(object);
    if (Object.keys(said).length === 0) return [];
    const step = place - before;
    before = place;
    return [[step, said]];
  });
  const course = courseNewsOf(scene);
  const news = {
    ...(entries.length > 0 && { objects: entries }),
    ...(Object.keys(course).length > 0 && { course }),
  };
  return Object.keys(news).length === 0 ? '' : JSON.stringify(news);
}

/** An object of a course, or what is new of it, and its place. */
export interface PlacedNews {
  readonly place: number;
  readonly said: Readonly<Record<string, unknown>>;
}

/** The news of a course; unchecked but for its form. */
export interface News {
  readonly objects: readonly PlacedNews[];
  readonly course: Readonly<Record<string, unknown>>;
}

/** The news of such a text; `null`: it is none. */
export function newsOfText(text: string): News | null {
  if (text === '') return { objects: [], course: {} };
  const value = parsed(text);
  if (!isRecord(value)) return null;
  const { objects = [], course = {} } = value;
  if (!Array.isArray(objects) || !isRecord(course)) return null;
  let at = 0;
  const placed = objects.map((entry) => {
    const read = entryOf(entry);
    at += read?.place ?? 0;
    return read && { ...read, place: at };
  });
  return placed.every((entry) => entry !== null) ? { objects: placed, course } : null;
}

/** An entry with its step in the place of its place. */
function entryOf(entry: unknown): PlacedNews | null {
  if (!Array.isArray(entry)) return null;
  const [place, said] = entry as readonly unknown[];
  return typeof place === 'number' && Number.isInteger(place) && place >= 0 && isRecord(said) ? { place, said } : null;
}

function parsed(text: string): unknown {
  try {
    return JSON.parse(text) as unknown;
  } catch {
    return null;
  }
}

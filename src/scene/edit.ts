import { isSame } from '#core/same';

import { withRobot } from './robot-values';
import type { League } from './league/league';
import {
  sceneDefaults,
  type Background,
  type Point,
  type RobotStart,
  type Scene,
  type SceneObject,
  type Task,
} from './scene';

/** Everything that can be done to a course. Plain data: it can be logged, sent and replayed. */
export type SceneEdit =
  /**
   * Puts objects on top of the others; their ids must be free. `at`: puts them, one after the other, at these places of the
   * order of painting instead; 0 lies below all others.
   */
  | { readonly type: 'add'; readonly objects: readonly SceneObject[]; readonly at?: readonly number[] }
  | { readonly type: 'remove'; readonly ids: readonly string[] }
  /** Replaces objects and keeps the order of painting: by changed objects, or by the pieces of a stroke. */
  | { readonly type: 'replace'; readonly changes: readonly Replacement[] }
  | { readonly type: 'robot'; readonly robot: Partial<RobotStart> }
  /** Changes the course as a whole. */
  | { readonly type: 'course'; readonly changes: CourseChanges }
  /** Removes all objects; the background, the robot and the task stay. */
  | { readonly type: 'clear' }
  /** Several in one step. */
  | { readonly type: 'all'; readonly edits: readonly SceneEdit[] };

/** An object and what becomes of it: nothing, one or several objects. */
export interface Replacement {
  readonly id: string;
  readonly by: readonly SceneObject[];
}

/**
 * New values for the course as a whole; `null` removes background or league, the usual `ambient` leaves it out again.
 */
export interface CourseChanges {
  readonly name?: string;
  readonly description?: string;
  readonly size?: Point;
  readonly task?: Task;
  readonly background?: Background | null;
  readonly league?: League | null;
  readonly ambient?: number;
}

/**
 * The course after an edit. Unchanged parts stay the same objects, so that a picture can see what changed; an edit that
 * changes nothing returns the same scene.
 */
export function applyEdit(scene: Scene, edit: SceneEdit): Scene {
  switch (edit.type) {
    case 'add':
      return edit.objects.length === 0 ? scene : { ...scene, objects: withAdded(scene.objects, edit.objects, edit.at) };
    case 'remove': {
      const gone = new Set(edit.ids);
      return withObjects(
        scene,
        scene.objects.filter(({ id }) => !gone.has(id)),
      );
    }
    case 'replace':
      return withObjects(scene, replaced(scene.objects, edit.changes));
    case 'robot': {
      const robot = withRobot(scene.robot, edit.robot);
      return isSame(scene.robot, robot) ? scene : { ...scene, robot };
    }
    case 'course': {
      const changed = withCourse(scene, edit.changes);
      return courseParts.every((part) => isSame(scene[part], changed[part])) ? scene : changed;
    }
    case 'clear':
      return withObjects(scene, []);
    case 'all':
      return edit.edits.reduce(applyEdit, scene);
    default:
      return edit satisfies never;
  }
}

/** The parts of a course as a whole. */
export const courseParts = ['name', 'description', 'size', 'task', 'background', 'league', 'ambient'] as const;

/** A course with other values; one without a league, or in a room as bright as any, does not name it. */
export function withCourse(scene: Scene, { league, ...changes }: CourseChanges): Scene {
  const { league: before, ...others } = { ...scene, ...changes };
  const scored = league === undefined ? before : league;
  return withoutUsualLight({ ...others, ...(scored ? { league: scored } : {}) });
}

/** A course that does not say that its room is as bright as any. */
function withoutUsualLight(scene: Scene): Scene {
  const { ambient, ...rest } = scene;
  return ambient === undefined || ambient === sceneDefaults.ambient ? rest : scene;
}

function withAdded(
  objects: readonly SceneObject[],
  added: readonly SceneObject[],
  at: readonly number[] = [],
): readonly SceneObject[] {
  const all = [...objects];
  for (const [index, object] of added.entries()) all.splice(at[index] ?? all.length, 0, object);
  return all;
}

function replaced(objects: readonly SceneObject[], changes: readonly Replacement[]): readonly SceneObject[] {
  const by = new Map(changes.map((change) => [change.id, change.by]));
  return objects.flatMap((object) => {
    const successors = by.get(object.id);
    return successors?.map((successor) => (isSame(object, successor) ? object : successor)) ?? [object];
  });
}

const withObjects = (scene: Scene, objects: readonly SceneObject[]): Scene =>
  objects.length === scene.objects.length && objects.every((object, index) => object === scene.objects[index])
    ? scene
    : { ...scene, objects };

/** The single edits of one, in their order. */
export const singleEdits = (edit: SceneEdit): readonly SceneEdit[] =>
  edit.type === 'all' ? edit.edits.flatMap(singleEdits) : [edit];

/** The objects that a single edit puts into the course: new ones, and changed ones as they are afterwards. */
export function objectsPut(edit: SceneEdit): readonly SceneObject[] {
  if (edit.type === 'add') return edit.objects;
  return edit.type === 'replace' ? edit.changes.flatMap(({ by }) => by) : [];
}

/** An id that no object has: `wall-1`, `wall-2`, … The same scene always gives the same. `taken`: further ids to avoid. */
export function freeId(scene: Scene, prefix: string, taken: readonly string[] = []): string {
  const ids = new Set([...scene.objects.map(({ id }) => id), ...taken]);
  for (let number = 1; ; number += 1) {
    const id = `${prefix}-${String(number)}`;
    if (!ids.has(id)) return id;
  }
}

import { applyEdit, objectsPut, singleEdits, type CourseChanges, type Replacement, type SceneEdit } from './edit';
import { robotValues } from './robot-values';
import { countPoints, sceneDefaults, sceneLimits, type Scene, type SceneObject } from './scene';

/**
 * The edit that takes another one back: done after it, it gives a course equal to `scene`, its objects in the same order.
 * It stays within what one edit may hold (`check-edit.ts`), however much the other one does and undoes.
 *
 * @param scene the course before `edit`, which must suit it (`editProblem`)
 */
export function inverse(scene: Scene, edit: SceneEdit): SceneEdit {
  switch (edit.type) {
    case 'add':
      return scene.objects.length === 0 ? { type: 'clear' } : { type: 'remove', ids: edit.objects.map(({ id }) => id) };
    case 'remove':
      return combined(putBack(scene, new Map(edit.ids.map((id) => [id, []]))));
    case 'replace':
      return combined(putBack(scene, new Map(edit.changes.map(({ id, by }) => [id, by]))));
    case 'robot':
      return { type: 'robot', robot: valuesOf(robotValues(scene.robot), edit.robot) };
    case 'course':
      return { type: 'course', changes: valuesOf(courseValues(scene), edit.changes) };
    case 'clear':
      return { type: 'add', objects: scene.objects };
    case 'all': {
      const edits = allBack(scene, edit.edits);
      return fitsIntoOne(edits) ? combined(edits) : wholeOf(scene);
    }
    default:
      return edit satisfies never;
  }
}

/** The values of a course as a whole, also of what it leaves out. */
const courseValues = (scene: Scene): Required<CourseChanges> => {
  const { name, description, size, task, background, league = null, ambient = sceneDefaults.ambient } = scene;
  return { name, description, size, task, background, league, ambient };
};

const combined = (edits: readonly SceneEdit[]): SceneEdit => {
  const [only] = edits;
  return edits.length === 1 && only !== undefined ? only : { type: 'all', edits };
};

/** Puts objects in the place of what became of them; those of which nothing is left take their old places among the others. */
function putBack(scene: Scene, became: ReadonlyMap<string, readonly SceneObject[]>): readonly SceneEdit[] {
  const changes: Replacement[] = [];
  const objects: SceneObject[] = [];
  const at: number[] = [];
  for (const [index, object] of scene.objects.entries()) {
    const successors = became.get(object.id);
    const [first, ...rest] = successors ?? [];
    if (first) changes.push({ id: first.id, by: [object] }, ...rest.map(({ id }) => ({ id, by: [] })));
    else if (successors) at[objects.push(object) - 1] = index;
  }
  const onTop = at[0] === scene.objects.length - at.length;
  return [
    ...(changes.length > 0 ? [{ type: 'replace', changes } as const] : []),
    ...(objects.length > 0 ? [{ type: 'add', objects, ...(onTop ? {} : { at }) } as const] : []),
  ];
}

/** The values that an object has for the properties that are named. */
function valuesOf<T extends object>(object: T, named: Partial<T>): Partial<T> {
  const values: Partial<T> = {};
  for (const key of Object.keys(named) as (keyof T)[]) values[key] = object[key];
  return values;
}

/** The inverses of several edits, the last one's first. */
function allBack(scene: Scene, edits: readonly SceneEdit[]): readonly SceneEdit[] {
  const back: (readonly SceneEdit[])[] = [];
  let before = scene;
  for (const edit of edits) {
    back.push(singleEdits(inverse(before, edit)));
    before = applyEdit(before, edit);
  }
  return back.reverse().flat();
}

function fitsIntoOne(edits: readonly SceneEdit[]): boolean {
  let [objects, points] = [0, 0];
  for (const object of edits.flatMap(objectsPut)) {
    objects += 1;
    points += countPoints(object);
  }
  return edits.length <= sceneLimits.objects && objects <= 2 * sceneLimits.objects && points <= sceneLimits.points;
}

/** The edit that turns any course into this one. */
const wholeOf = (scene: Scene): SceneEdit => ({
  type: 'all',
  edits: [
    { type: 'clear' },
    { type: 'add', objects: scene.objects },
    { type: 'robot', robot: robotValues(scene.robot) },
    { type: 'course', changes: courseValues(scene) },
  ],
});

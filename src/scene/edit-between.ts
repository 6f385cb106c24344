import type { CourseChanges, Replacement, SceneEdit } from './edit';
import type { Scene, SceneObject } from './scene';

/**
 * The edit that makes `after` of `before`, or `null` where nothing differs: undoing and redoing as something that can be
 * told to a run. Objects that are the same object in both count as unchanged, so courses that came about by `applyEdit`
 * give small edits.
 */
export function editBetween(before: Scene, after: Scene): SceneEdit | null {
  if (before === after) return null;
  const edits = [
    ...objectEdits(before.objects, after.objects),
    ...(before.robot === after.robot ? [] : [{ type: 'robot', robot: after.robot } as const]),
    ...courseEdits(before, after),
  ];
  const [only] = edits;
  if (only === undefined) return null;
  return edits.length === 1 ? only : { type: 'all', edits };
}

function courseEdits(before: Scene, after: Scene): readonly SceneEdit[] {
  const changes: CourseChanges = {
    ...(before.name === after.name ? {} : { name: after.name }),
    ...(before.description === after.description ? {} : { description: after.description }),
    ...(before.size === after.size ? {} : { size: after.size }),
    ...(before.task === after.task ? {} : { task: after.task }),
    ...(before.background === after.background ? {} : { background: after.background }),
  };
  return Object.keys(changes).length === 0 ? [] : [{ type: 'course', changes }];
}

function objectEdits(before: readonly SceneObject[], after: readonly SceneObject[]): readonly SceneEdit[] {
  if (before === after) return [];
  const afterById = new Map(after.map((object) => [object.id, object]));
  const kept = before.filter(({ id }) => afterById.has(id));
  const keptIds = new Set(kept.map(({ id }) => id));
  const order = after.filter(({ id }) => keptIds.has(id));
  if (kept.length === 0 || kept.some(({ id }, at) => order[at]?.id !== id)) {
    const edits: SceneEdit[] = [];
    if (before.length > 0) edits.push({ type: 'clear' });
    if (after.length > 0) edits.push({ type: 'add', objects: after });
    return edits;
  }
  return keptInOrder(before, after, keptIds);
}

/** Both have objects in common, in the same order: what is new in between goes in together with the one before it. */
function keptInOrder(
  before: readonly SceneObject[],
  after: readonly SceneObject[],
  keptIds: ReadonlySet<string>,
): readonly SceneEdit[] {
  const groups = groupsOf(after, keptIds);
  const beforeById = new Map(before.map((object) => [object.id, object]));
  const last = groups[groups.length - 1];
  const changes: Replacement[] = before.filter(({ id }) => !keptIds.has(id)).map(({ id }) => ({ id, by: [] }));
  const added: SceneObject[] = [];
  for (const group of groups) {
    const at = group.by.findIndex(({ id }) => id === group.id);
    // What comes after the last one simply lies on top.
    const by = group === last ? group.by.slice(0, at + 1) : group.by;
    if (group === last) added.push(...group.by.slice(at + 1));
    if (by.length > 1 || by[0] !== beforeById.get(group.id)) changes.push({ id: group.id, by });
  }
  const gone = changes.every(({ by }) => by.length === 0);
  return [
    ...(changes.length === 0
      ? []
      : [
          gone
            ? ({ type: 'remove', ids: changes.map(({ id }) => id) } as const)
            : ({ type: 'replace', changes } as const),
        ]),
    ...(added.length === 0 ? [] : [{ type: 'add', objects: added } as const]),
  ];
}

/** Each object that stays, with the new ones behind it; the first one also with those before it. */
function groupsOf(after: readonly SceneObject[], keptIds: ReadonlySet<string>): readonly Replacement[] {
  const groups: { id: string; by: SceneObject[] }[] = [];
  let ahead: SceneObject[] = [];
  for (const object of after) {
    const group = groups[groups.length - 1];
    if (keptIds.has(object.id)) {
      groups.push({ id: object.id, by: [...ahead, object] });
      ahead = [];
    } else if (group === undefined) ahead.push(object);
    else group.by.push(object);
  }
  return groups;
}

import type { WaysToDraw } from '#check/report/drawing';
import { groupSign } from '#hint/groups/say';
import type { Group } from '#hint/groups/groups';
import type { ClassTask } from '#check/task/task';

import type { Row } from '../model/class-model';

/** The ways of a group's hand-ins, in the world in which it happened. */
export function waysOf(group: Group, rows: readonly Row[], task: ClassTask): WaysToDraw {
  const world = group.world ?? task.worlds[0].id;
  const results = new Map(rows.map(({ name, result }) => [name, result]));
  const trailOf = (name: string) => results.get(name)?.worlds.find(({ id }) => id === world)?.trail ?? [];
  return { world, trails: group.members.map(trailOf), tone: groupSign(group), example: null, mark: null };
}

/** The same with its example before the others, and the place marked at which it happened. @param text to the mark */
export function waysWithExample(group: Group, rows: readonly Row[], task: ClassTask, text: string): WaysToDraw {
  const ways = waysOf(group, rows, task);
  const { place } = group;
  const example = ways.trails[group.members.indexOf(group.example)] ?? null;
  const mark = place === null ? null : { ...place, text };
  return { ...ways, example, mark };
}

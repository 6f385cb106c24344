import type { Scene, SceneObject } from '#scene/scene';
import { pendingChanges } from '#simulation/at-once';

import { t } from '../../../kit/i18n';
import words from '.';
import kindNames from './kinds';

const texts = words.waiting;

/** The most kinds of objects that are named. Chosen: what fits on one line of a phone. */
const MOST_NAMED = 2;

/**
 * A sentence about the changes that take effect only at the next start. `start`: the course with which the run began.
 */
export function waitingWords(start: Scene, now: Scene): string {
  const { coming, going, robot, arena } = pendingChanges(start, now);
  const ids = new Set(coming.map(({ id }) => id));
  const counts = new Map<SceneObject['type'], number>();
  for (const { type } of [...coming, ...going.filter(({ id }) => !ids.has(id))])
    counts.set(type, (counts.get(type) ?? 0) + 1); // a changed object counts as both removed and added: name it once
  const names = [...counts].map(([type, count]) => t(kindNames[type][count === 1 ? 'one' : 'many']));
  if (robot) names.push(t(texts.start));
  if (arena) names.push(t(texts.size));
  const isShort = names.length > 0 && names.length <= MOST_NAMED;
  return isShort ? t(texts.named, { what: names.join(', ') }) : t(texts.unnamed);
}

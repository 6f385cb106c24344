import type { Scene, SceneObject } from '#scene/scene';
import { pendingChanges } from '#simulation/at-once';

import { say } from '../../page/i18n/say';
import { editorWords as words } from './editor-words';

const texts = words.waiting;

/** So many sorts of things are named. Chosen: what fits on a line of a phone. */
const MOST_NAMED = 2;

/** What of a course a run waits for its next start with, in a sentence. `start`: the course as the run began with it. */
export function waitingWords(start: Scene, now: Scene): string {
  const { coming, going, robot, arena } = pendingChanges(start, now);
  const ids = new Set(coming.map(({ id }) => id));
  const counts = new Map<SceneObject['type'], number>();
  for (const { type } of [...coming, ...going.filter(({ id }) => !ids.has(id))])
    counts.set(type, (counts.get(type) ?? 0) + 1); // what is otherwise now comes and goes: named once
  const names = [...counts].map(([type, count]) => say(words.kinds[type][count === 1 ? 'one' : 'many']));
  if (robot) names.push(say(texts.start));
  if (arena) names.push(say(texts.size));
  const isShort = names.length > 0 && names.length <= MOST_NAMED;
  return isShort ? say(texts.named, { what: names.join(', ') }) : say(texts.unnamed);
}

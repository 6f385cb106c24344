import type { Texts } from '#core/texts';
import type { Scene, SceneObject } from '#scene/scene';

import { waitsForStart as isBuiltIn } from '../canvas/live-scene';
import { say } from '../i18n/say';
import { kindTexts } from './object-words';

const texts = {
  start: { de: 'Start', en: 'Start' },
  size: { de: 'Grösse', en: 'Size' },
  named: { de: '{what}: gilt erst, wenn du neu startest.', en: '{what}: takes effect when you start again.' },
  unnamed: { de: 'Gilt erst, wenn du neu startest.', en: 'Takes effect when you start again.' },
} as const satisfies Readonly<Record<string, Texts>>;

/** So many sorts of things are named. Chosen: what fits on a line of a phone. */
const MOST_NAMED = 2;

/** What of a course a run waits for its next start with, in a sentence. `start`: the course as the run began with it. */
export function waitingWords(start: Scene, now: Scene): string {
  const counts = new Map<SceneObject['type'], number>();
  for (const { type } of changed(start.objects, now.objects)) counts.set(type, (counts.get(type) ?? 0) + 1);
  const names = [...counts].map(([type, count]) => say(kindTexts[type][count === 1 ? 'one' : 'many']));
  if (!isSame(start.robot, now.robot)) names.push(say(texts.start));
  if (!isSame(start.size, now.size)) names.push(say(texts.size));
  const isShort = names.length > 0 && names.length <= MOST_NAMED;
  return isShort ? say(texts.named, { what: names.join(', ') }) : say(texts.unnamed);
}

/** What is new, other than before, or gone, each once. */
function changed(before: readonly SceneObject[], after: readonly SceneObject[]): readonly SceneObject[] {
  const earlier = new Map(before.filter(isBuiltIn).map((object) => [object.id, object]));
  const others = after.filter(isBuiltIn).filter((object) => {
    const same = isSame(earlier.get(object.id), object);
    earlier.delete(object.id);
    return !same;
  });
  return [...others, ...earlier.values()];
}

const isSame = (one: unknown, other: unknown): boolean =>
  one === other || JSON.stringify(one) === JSON.stringify(other);

import { fnvOfText } from '#core/fnv';
import type { Scene } from '#scene/scene';
import { serializeScene } from '#scene/serialize';

/** A course as it is compared: words and pictures do not matter; a link may have had no room for them. */
function bareText({ background, task: { card: _, ...task }, ...scene }: Scene): string {
  const bare = { ...scene, name: '', description: '', task };
  return serializeScene({ ...bare, background: background && { ...background, picture: '' } });
}

/** True if two courses are the same for driving. */
export const isSameCourse = (one: Scene, other: Scene): boolean => bareText(one) === bareText(other);

/** Fingerprint of a course, to detect changes. */
export const courseMark = (scene: Scene): string => fnvOfText(bareText(scene)).toString(36);

import type { Scene, SceneObject } from '#scene/scene';

import { t } from '../../kit/i18n';
import words from './words';

/** The things of a world of WebTigerPython, counted, and its size in cm. */
export function worldInWords({ objects, size }: Scene): string {
  const count = (...types: readonly SceneObject['type'][]): number =>
    objects.filter(({ type }) => types.includes(type)).length;
  return [
    ...counted(count('wall'), [words.wall, words.walls]),
    ...counted(count('block', 'fixed-block'), [words.block, words.blocks]),
    t(words.start),
    `${size.map((mm) => String(mm / 10)).join(' × ')} cm`,
  ].join(', ');
}

const counted = (count: number, [one, many]: readonly [typeof words.wall, typeof words.walls]): readonly string[] =>
  count === 0 ? [] : [t(count === 1 ? one : many, { count })];

import { shallowRef } from 'vue';

import type { CourseKind } from '#catalogue/course';
import { newSeed, type RandomKind, type RandomWish } from '../../work/catalogue/random-wish';

export type Filter = CourseKind | 'all' | 'random';

/** Which courses the gallery shows; as it was left, as long as the page is open. */
export const filter = shallowRef<Filter>('all');

/** The random course of each kind that was last looked at, so that coming back shows the same one. */
export const lastRandom = shallowRef<Readonly<Record<RandomKind, RandomWish>>>({
  maze: { kind: 'maze', size: 'm', seed: newSeed() },
  track: { kind: 'track', size: 'm', seed: newSeed() },
});

import { shallowRef } from 'vue';

import type { CourseKind } from '#catalogue/course';
import { lateModel } from '../../../kit/state/late-models';
import { newSeed, type RandomKind, type RandomWish } from '../../../session/work/catalogue/random-wish';

export type Filter = CourseKind | 'all' | 'random';

/** The state in which the gallery was left, as long as the page is open. */
export const gallerySession = lateModel(() => ({
  /** The courses it shows. */
  filter: shallowRef<Filter>('all'),
  /** The random course of each kind that was last looked at, so that coming back shows the same one. */
  lastRandom: shallowRef<Readonly<Record<RandomKind, RandomWish>>>({
    maze: { kind: 'maze', size: 'm', seed: newSeed() },
    track: { kind: 'track', size: 'm', seed: newSeed() },
  }),
}));

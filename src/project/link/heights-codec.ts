import { sceneLimits } from '#scene/scene';

import { mapped, record, type Codec } from './codec';
import type { SharedCodecs } from './scene-codec';

/** A height of its own that an object has, and the object's place in its course: the additions of link version 10. */
export interface PlacedHeight {
  readonly place: number;
  /** In mm. */
  readonly height: number;
}

/** The codec of the heights of things. */
export function heightsCodec({ columns }: SharedCodecs): Codec<readonly PlacedHeight[]> {
  const step = columns.uint();
  const height = columns.uint();
  // Most things in a row have the same height: the place is a step from the one before, so that both repeat.
  return mapped(
    columns.list(record<PlacedHeight>({ place: step, height }), sceneLimits.objects),
    (placed) => placed.map(({ place, height }, index) => ({ place: place - (placed[index - 1]?.place ?? 0), height })),
    (steps) => {
      let at = 0;
      return steps.map(({ place, height }) => {
        at += place;
        return { place: at, height };
      });
    },
  );
}

import type { Vec } from '#core/geometry';
import type { Rng } from '#core/rng';
import { moverWays } from '#scene/kinds/mover-way';
import { paintColors } from '#scene/paint/paint';
import { defaultScene, type Point, type Scene } from '#scene/scene';
import { oneOf, wholeFrom } from '#scene/testing/fuzz';
import { randomObject } from '#scene/testing/random-scene';
import { shapeNames } from '#scene/shape/shape';
import { usualToolOptions } from '../tools/tool-options';
import { penShapes, type Drag, type Selection, type ToolOptions } from '../tools/tool';

const extent = (rng: Rng): Point => [wholeFrom(rng, 5, 300), wholeFrom(rng, 5, 300)];

/** A course with this many objects of any kind. */
export const randomCourse = (rng: Rng, objects: number): Scene => ({
  ...defaultScene(),
  robot: {
    ...defaultScene().robot,
    at: [wholeFrom(rng, 100, 1100), wholeFrom(rng, 100, 800)],
    heading: wholeFrom(rng, -180, 180),
  },
  objects: Array.from({ length: objects }, (_, index) =>
    randomObject(rng, `${oneOf(rng, ['wall', 'block', 'stroke', 'o'])}-${index}`),
  ),
});

/** Any setting of the tools. */
export const randomOptions = (rng: Rng): ToolOptions => ({
  ...usualToolOptions,
  penWidth: wholeFrom(rng, 1, 500),
  penColor: oneOf(rng, paintColors),
  penShape: oneOf(rng, penShapes),
  eraser: oneOf(rng, ['all', 'lines']),
  eraserWidth: wholeFrom(rng, 5, 300),
  block: oneOf(rng, ['block', 'fixed-block', 'spikes', 'mover']),
  moverWay: oneOf(rng, moverWays),
  moverWait: wholeFrom(rng, 0, 60),
  moverSpin: wholeFrom(rng, -360, 360),
  blockShape: oneOf(rng, shapeNames),
  blockSize: extent(rng),
  blockHeight: oneOf(rng, [null, wholeFrom(rng, 5, 1000)]),
  blockColor: oneOf(rng, [null, ...paintColors]),
  wallThickness: wholeFrom(rng, 2, 500),
  wallHeight: oneOf(rng, [null, wholeFrom(rng, 5, 1000)]),
  wallColor: oneOf(rng, [null, ...paintColors]),
  wallSnaps: rng.unit() < 0.7,
  mazeCell: wholeFrom(rng, 50, 400),
  zone: oneOf(rng, ['target', 'checkpoint', 'forbidden']),
  zoneShape: oneOf(rng, shapeNames),
  zoneBlocks: wholeFrom(rng, 0, 50),
  labelText: oneOf(rng, ['', ' Start ', 'a\nb', 'x'.repeat(300), '😀'.repeat(80)]),
  labelHeight: wholeFrom(rng, 5, 500),
  several: rng.unit() < 0.2,
  catches: oneOf(rng, ['frame', 'lasso']),
});

/** A selection of some of a course. */
export const randomSelection = (rng: Rng, scene: Scene): Selection => ({
  ids: scene.objects.filter(() => rng.unit() < 0.15).map(({ id }) => id),
  robot: rng.unit() < 0.3,
});

/** Any drag: taps, jumps, walks, scribbles, from corner to corner, also far outside the arena. */
export function randomDrag(rng: Rng): Drag {
  const path = randomPath(rng);
  const reachMm = oneOf(rng, [1, 6, 15, 60]);
  const keys = { free: rng.unit() < 0.3, adds: rng.unit() < 0.2, keeps: rng.unit() < 0.2, alt: rng.unit() < 0.2 };
  return { path, ...keys, reachMm, ...(rng.unit() < 0.3 ? { corners: path.length - 1 } : {}) };
}

function randomPath(rng: Rng): readonly Vec[] {
  const start = { x: -200 + rng.unit() * 1600, y: -200 + rng.unit() * 1300 };
  const far = (): Vec => ({ x: (rng.unit() - 0.5) * 1e6, y: (rng.unit() - 0.5) * 1e6 });
  switch (oneOf(rng, ['tap', 'jitter', 'jump', 'walk', 'walk', 'level', 'far'])) {
    case 'tap':
      return [start];
    case 'jitter':
      return walk(rng, start, wholeFrom(rng, 2, 6), 2);
    case 'jump':
      return [start, { x: rng.unit() * 1200, y: rng.unit() * 900 }];
    case 'level':
      return [start, { x: rng.unit() * 1200, y: start.y }];
    case 'far':
      return [rng.unit() < 0.5 ? start : far(), far(), rng.unit() < 0.5 ? start : far()];
    default:
      return walk(rng, start, wholeFrom(rng, 10, 400), oneOf(rng, [3, 20, 80]));
  }
}

/** A wandering path. */
export function walk(rng: Rng, start: Vec, places: number, stepMm: number): readonly Vec[] {
  const path = [start];
  let { x, y } = start;
  while (path.length < places) {
    x += (rng.unit() - 0.5) * 2 * stepMm;
    y += (rng.unit() - 0.5) * 2 * stepMm;
    path.push({ x, y });
  }
  return path;
}

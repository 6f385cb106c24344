import type { Vec } from '#core/geometry';
import { boundsOf } from '#scene/kinds/index';
import { boundsMeet, boundsOfOutline, overlapMm, type Outline } from '#scene/outline';
import { robotOutlines } from '#scene/placement';
import type { Scene } from '#scene/scene';
import { thinned } from '#scene/simplify';
import { meets, placeOf } from './kinds/index';
import { toVec } from './plane';
import { caughtBy } from './selection';
import type { Selection } from './tools/tool';

/** A lasso is made of straight pieces, nowhere farther than this from where it was drawn, in mm. */
const BESIDE_MM = 1;

/** Everything free that a lasso touches or has inside, with all of its groups; its end is joined to its beginning. */
export function thingsInLasso(scene: Scene, path: readonly Vec[], footprint: readonly Outline[] = []): Selection {
  const loop = thinned(path, BESIDE_MM);
  const around = boundsOfOutline(loop);
  const pieces = loop.map((place, index): Outline => [loop[index - 1] ?? loop[loop.length - 1] ?? place, place]);
  // What no piece of the lasso touches lies inside or outside as a whole.
  const catches = (place: Vec, isTouched: (piece: Outline) => boolean): boolean =>
    isInside(loop, place) || pieces.some(isTouched);
  return {
    ids: caughtBy(
      scene,
      (object) =>
        boundsMeet(boundsOf(object), around) && catches(toVec(placeOf(object)), (piece) => meets(object, piece)),
    ),
    robot: robotOutlines(scene.robot, footprint).some(
      (part) =>
        boundsMeet(boundsOfOutline(part), around) &&
        catches(toVec(scene.robot.at), (piece) => overlapMm(part, piece) >= 0),
    ),
  };
}

/** True if a place lies inside a loop: a ray to its right crosses the loop an odd number of times. */
function isInside(loop: readonly Vec[], { x, y }: Vec): boolean {
  let isIn = false;
  let before = loop[loop.length - 1];
  for (const place of loop) {
    if (before && place.y > y !== before.y > y) {
      const crossing = place.x + ((y - place.y) / (before.y - place.y)) * (before.x - place.x);
      if (x < crossing) isIn = !isIn;
    }
    before = place;
  }
  return isIn;
}

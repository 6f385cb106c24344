import { isZone, zoneContains } from '#scene/kinds/zone';
import type { Scene } from '#scene/scene';
import { FloorCover } from './floor-cover';
import { metAt, OPEN, type Standing, type Watcher } from './watcher';

/** Watches whether a movable block lies in a zone; taken away again, it does not any more. */
export function watchBelongs(
  course: Scene,
  { object, zone }: { readonly object: string; readonly zone: string },
): Watcher {
  const place = course.objects.filter(isZone).find(({ id }) => id === zone);
  let standing: Standing = OPEN;
  return {
    step: (run) => {
      const outline = run.blockLying(object);
      const isThere = outline !== null && place !== undefined && zoneContains(place, outline);
      if (isThere !== (standing !== OPEN)) standing = isThere ? metAt(run.nowUs) : OPEN;
    },
    standing: () => standing,
    reason: () => ({ code: 'belongs', params: { object, zone } }),
  };
}

/** Watches whether the robot's body was over so much of the floor. */
export function watchCovered(
  course: Scene,
  { percent, zone }: { readonly percent: number; readonly zone: string | null },
): Watcher {
  const cover = new FloorCover(course, zone);
  let standing: Standing = OPEN;
  return {
    step: (run) => {
      if (standing !== OPEN || run.pose === null) return;
      cover.visit(run.pose, () => run.body);
      if (cover.percent >= percent) standing = metAt(run.nowUs);
    },
    standing: () => standing,
    reason: () => ({ code: 'covered', params: { percent, found: Math.floor(cover.percent) } }),
  };
}

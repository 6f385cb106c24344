import { sceneLimits, type Point } from '#scene/scene';

import type { Codec, Columns } from './codec';
import type { ValueReader } from './values';
import { DamagedBytes } from './columns';

/**
 * The points of a line that was drawn by hand: each as its step from the one before, seen from where that one led. The
 * frame is mirrored so that the step before goes right and up, rather right than up: a hand goes on as it went, so the
 * first number is mostly positive and the second small, whichever way the line runs, and that packs a tenth better than
 * plain steps (measured: 1182 points in 1530 bytes instead of 1654).
 */
export function pathCodec(columns: Columns, start: Codec<Point>): Codec<readonly Point[]> {
  const count = columns.uint();
  const [along, across] = [columns.int(), columns.int()];
  const pointsRead = new WeakMap<ValueReader, number>();
  return {
    write(out, points) {
      count.write(out, points.length);
      let before: Point | null = null;
      let step: Point = NO_STEP;
      for (const point of points) {
        if (before === null) start.write(out, point);
        else {
          const next: Point = [point[0] - before[0], point[1] - before[1]];
          const [one, other] = mirrored(next, step);
          along.write(out, one);
          across.write(out, other);
          step = next;
        }
        before = point;
      }
    },
    read(from) {
      const length = count.read(from);
      const all = (pointsRead.get(from) ?? 0) + length;
      if (all > sceneLimits.points) throw new DamagedBytes();
      pointsRead.set(from, all);
      const points: Point[] = [];
      let before: Point | null = null;
      let step: Point = NO_STEP;
      for (let index = 0; index < length; index += 1) {
        if (before === null) before = start.read(from);
        else {
          step = unmirrored([along.read(from), across.read(from)], step);
          before = [before[0] + step[0], before[1] + step[1]];
        }
        points.push(before);
      }
      return points;
    },
  };
}

const NO_STEP: Point = [1, 0];

/** A step in the frame of the one before. Adding 0 leaves no negative zero. */
function mirrored([x, y]: Point, [beforeX, beforeY]: Point): Point {
  const right = beforeX < 0 ? -x + 0 : x;
  const up = beforeY < 0 ? -y + 0 : y;
  return isSteep(beforeX, beforeY) ? [up, right] : [right, up];
}

function unmirrored([one, other]: Point, [beforeX, beforeY]: Point): Point {
  const [right, up] = isSteep(beforeX, beforeY) ? [other, one] : [one, other];
  return [beforeX < 0 ? -right + 0 : right, beforeY < 0 ? -up + 0 : up];
}

const isSteep = (x: number, y: number): boolean => Math.abs(y) > Math.abs(x);

import type { Point } from '#scene/scene';

import type { Codec, Columns } from './codec';
import { lineCodec } from './line-codec';

/**
 * The points of a line that was drawn by hand: each as its step from the previous one, relative to the direction of
 * that one. The frame is mirrored so that the previous step goes right and up, more right than up. A hand tends to go
 * on in its direction, so the first number is mostly positive and the second small, whatever the direction of the line.
 * That packs a tenth better than plain steps (measured: 1182 points in 1530 bytes instead of 1654).
 */
export function pathCodec(columns: Columns, start: Codec<Point>): Codec<readonly Point[]> {
  const count = columns.uint();
  const [along, across] = [columns.int(), columns.int()];
  return lineCodec(count, start, () => {
    let last: Point = NO_STEP;
    return {
      write(out, step) {
        const [one, other] = mirrored(step, last);
        along.write(out, one);
        across.write(out, other);
        last = step;
      },
      read(from) {
        last = unmirrored([along.read(from), across.read(from)], last);
        return last;
      },
    };
  });
}

const NO_STEP: Point = [1, 0];

/** A step in the frame of the previous one. Adding 0 avoids a negative zero. */
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

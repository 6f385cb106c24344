import { sceneLimits, type Point } from '#scene/scene';

import type { Codec } from './codec';
import { DamagedBytes } from './damaged-bytes';
import type { ValueReader, ValueWriter } from './value-port';

/** How one line is coded: step by step, in whole mm, each from the previous ones. */
export interface Steps {
  write(out: ValueWriter, step: Point): void;
  read(from: ValueReader): Point;
}

/**
 * The points of lines: their number, the first one, and the steps from each to the next. Reading all lines of a course
 * gives `sceneLimits.points` points at most.
 *
 * @param begin called for every line
 */
export function lineCodec(count: Codec<number>, start: Codec<Point>, begin: () => Steps): Codec<readonly Point[]> {
  const pointsRead = new WeakMap<ValueReader, number>();
  return {
    write(out, points) {
      count.write(out, points.length);
      const steps = begin();
      points.forEach((point, index) => {
        const before = points[index - 1];
        if (before === undefined) start.write(out, point);
        else steps.write(out, [point[0] - before[0], point[1] - before[1]]);
      });
    },
    read(from) {
      const length = count.read(from);
      const all = (pointsRead.get(from) ?? 0) + length;
      if (all > sceneLimits.points) throw new DamagedBytes();
      pointsRead.set(from, all);
      const points: Point[] = [];
      const steps = begin();
      for (let index = 0; index < length; index += 1) {
        const before = points[index - 1];
        if (before === undefined) points.push(start.read(from));
        else {
          const step = steps.read(from);
          points.push([before[0] + step[0], before[1] + step[1]]);
        }
      }
      return points;
    },
  };
}

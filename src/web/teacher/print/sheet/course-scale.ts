import type { Point } from '#scene/scene';

import { RIM_SHARE } from '../shapes/rim-share';

/** A course as it is drawn on the sheet. */
export interface DrawnCourse {
  /** Number of mm of the course per mm on the sheet. */
  readonly scale: number;
  /** Width and height of the drawing with its rim, in mm. */
  readonly size: Point;
}

/**
 * A course as large as a room of this width and height allows. The scale is a number to calculate with: 1 : 1, 1 : 1.5, 1 : 2,
 * 1 : 2.5, and whole ones from 1 : 3 on; never larger than it is.
 */
export function drawnCourse([width, height]: Point, room: Point): DrawnCourse {
  const rim = 2 * RIM_SHARE * Math.max(width, height);
  const needed = Math.max((width + rim) / room[0], (height + rim) / room[1], 1);
  const scale = needed <= 2.5 ? Math.ceil(2 * needed) / 2 : Math.ceil(needed);
  return { scale, size: [(width + rim) / scale, (height + rim) / scale] };
}

/** Length of the bar that shows the scale: 1, 2 or 5 times a power of ten, up to 45 mm on the sheet. @returns mm of the course */
export function barMm(scale: number): number {
  const most = 45 * scale;
  const power = 10 ** Math.floor(Math.log10(most));
  return power * ([5, 2].find((factor) => factor * power <= most) ?? 1);
}

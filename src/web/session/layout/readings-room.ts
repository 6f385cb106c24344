/** The readings under the arena, as far as they need room. */
export interface ReadingsParts {
  /** Number of line sensors, and digits of their longest reading. */
  readonly count: number;
  readonly digits: number;
  /** True if the robot measures a distance, whether it has a lidar, and whether it carries a bumper. */
  readonly distance: boolean;
  readonly lidar: boolean;
  readonly bumper: boolean;
  /** Number of colour sensors. */
  readonly colours?: number;
}

/** Widths in CSS px, measured in the page with Liberation Sans (as wide as Arial) of 14 px, with the space around. */
const WIDTHS = { distance: 123, lidar: 104, colour: 148, line: 48, sensor: 24, digit: 7.8, bumper: 104 };

/** Width that the readings need with the numbers of all line sensors, in CSS px. */
export function readingsPx({ count, digits, distance, lidar, bumper, colours = 0 }: ReadingsParts): number {
  const line = count === 0 ? 0 : WIDTHS.line + count * (WIDTHS.sensor + WIDTHS.digit * Math.max(3, digits));
  return (
    colours * WIDTHS.colour +
    (distance ? WIDTHS.distance : 0) +
    (lidar ? WIDTHS.lidar : 0) +
    line +
    (bumper ? WIDTHS.bumper : 0)
  );
}

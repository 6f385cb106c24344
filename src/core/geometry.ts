/** A point or a displacement in mm; x right and y up in the world, x forward and y left on a robot. */
export interface Vec {
  readonly x: number;
  readonly y: number;
}

/** Pose of a body: the position of its origin in world mm and its heading in rad, counter-clockwise from +x. */
export interface Pose {
  readonly xMm: number;
  readonly yMm: number;
  readonly headingRad: number;
}

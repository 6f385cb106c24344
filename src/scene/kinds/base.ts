/** The parts that several kinds of objects of a course share. */

/** A place or an extent `[x, y]` in whole mm. */
export type Point = readonly [x: number, y: number];

/** The properties that every object may have. */
export interface Common {
  readonly id: string;
  /** The editor does not change it. Left out: it does. */
  readonly lock?: true;
  /** Name of the group to which it belongs, with at least one more object; left out: none. */
  readonly group?: string;
}

/** A filled part of the plane: a rectangle, an ellipse or a polygon. */
export interface Shaped {
  /** The middle of its rectangle. */
  readonly at: Point;
  /** Extent along its own x and y, in mm. */
  readonly size: Point;
  /** Rotation in degrees counter-clockwise, 0 up to but without 360. */
  readonly angle: number;
  /** The ellipse within `size` instead of the rectangle. */
  readonly round?: boolean;
  /**
   * The corners of a polygon, in order: its figure in its own frame, stretched so that it fills `size`. Left out: a
   * rectangle, or what `round` says. No edges cross, and what it encloses may be hollow (concave).
   */
  readonly corners?: readonly Point[];
}

/** A thing that stands up from the floor. */
export interface Standing {
  /** Its top above the floor in whole mm, for sensors: robots bump into it at any height. Left out: usual for its kind. */
  readonly height?: number;
}

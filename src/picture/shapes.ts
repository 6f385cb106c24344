import type { Point } from '#scene/scene';

/** Colours and lines of a shape; lengths in mm. */
export interface Paint {
  readonly fill?: string | undefined;
  readonly stroke?: string | undefined;
  readonly width?: number | undefined;
  /** Opacity of fill and line. */
  readonly opacity?: number | undefined;
  readonly dash?: readonly number[] | undefined;
  /** Offset of the line's start in the dashes. */
  readonly dashFrom?: number | undefined;
  readonly cap?: 'round' | undefined;
  readonly join?: 'round' | undefined;
}

/** Lines through places; closed, they are polygons. */
interface Lines {
  readonly form: 'lines';
  readonly lines: readonly (readonly Point[])[];
  readonly isClosed?: boolean;
}
interface Ellipse {
  readonly form: 'ellipse';
  readonly at: Point;
  readonly radii: Point;
}
/** A rectangle by its upper left corner; `round`: the radius of its corners. Only within a group. */
interface Rect {
  readonly form: 'rect';
  readonly at: Point;
  readonly size: Point;
  readonly round: number;
}

/** The outline of a shape. */
export type Geometry = Lines | Ellipse | Rect;

/** A picture of 24 units, this many mm wide, in the middle of its group. */
interface Icon {
  readonly form: 'icon';
  readonly path: string;
  readonly across: number;
}

/** Words on a base line. Only within a group. */
export interface Words {
  readonly form: 'words';
  readonly text: string;
  /** The middle of the base line, or its start. */
  readonly at: Point;
  readonly from: 'middle' | 'start';
  /** Size of the font. */
  readonly size: number;
  readonly weight: 600 | 700;
  readonly fill: string;
  /** On a screen: a rim around the letters, so that they can be read on a line. */
  readonly rim?: { readonly color: string; readonly width: number };
  /** On a screen: the letters are squeezed so that they take no more. */
  readonly mostMm?: number;
}

/** Shapes in a frame of their own, y down, turned counter-clockwise by degrees. */
export interface Group {
  readonly form: 'group';
  readonly at: Point;
  readonly turn: number;
  readonly inside: readonly Shape[];
}

/**
 * A part of a picture, in mm, whatever it is drawn with. Places are those of the world, y up; within a group they are those of
 * its frame, y down.
 */
export type Shape = ((Geometry | Icon) & Paint) | Words | Group;

/** Shapes in a frame at a place, by default upright. */
export const group = (at: Point, inside: readonly Shape[], turn = 0): Group => ({ form: 'group', at, turn, inside });

/** A circle. */
export const circle = (radius: number, paint: Paint, at: Point = [0, 0]): Shape => ({
  ...{ form: 'ellipse', at, radii: [radius, radius] },
  ...paint,
});

/** A rectangle around the origin of its group. */
export const rect = ([width, height]: Point, round: number, paint: Paint): Shape => ({
  ...{ form: 'rect', at: [-width / 2, -height / 2], size: [width, height], round },
  ...paint,
});

/** Bold words in the middle of a group. */
export const written = (text: string, size: number, fill: string, x = 0): Words => ({
  ...{ form: 'words', text, at: [x, size * 0.355], from: 'middle', size, weight: 700, fill }, // half the height of a figure
});

import type { Common, Point } from './base';

/**
 * A tag: a printed pattern of the family 36h11 that cameras recognise. It stands upright on the floor, stuck to a wall or a
 * block, or lies flat. It is paper: nothing bumps into it, and line sensors do not see it.
 */
export interface Tag extends Common {
  readonly type: 'tag';
  /** The middle of its lower edge; of one that lies its middle. */
  readonly at: Point;
  /** Its place in the family, 1 … 99. */
  readonly number: number;
  /** Side of its black square in mm. */
  readonly side: number;
  /** Degrees counter-clockwise from +x: the direction of its printed side; of one that lies its rotation. */
  readonly angle: number;
  /** It lies on the floor. Left out: it stands. */
  readonly flat?: true;
}

/** Cells along the black square; the white rim is one cell wide. */
export const TAG_CELLS = 8;

/** Width of the white rim around the black square, in mm. */
export const tagRimMm = (side: number): number => side / TAG_CELLS;

/** Side of the whole sheet, in mm. */
export const tagSheetMm = (side: number): number => side + 2 * tagRimMm(side);

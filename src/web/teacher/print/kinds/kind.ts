import type { jsPDF } from 'jspdf';
import type { AnyObject } from '#scene/kinds/kind';
import type { Bounds } from '#scene/outline';
import type { Point, SceneObject } from '#scene/scene';

/** From world mm (y up) to the picture's mm (y down). */
export type ToPicture = (at: Point) => Point;

/** From world mm to mm on the sheet, from its upper left corner. */
export type ToSheet = (at: Point) => Point;

/** A kind of object as it is printed: in a picture, and on sheets of paper true to scale. */
export interface PrintKind<O extends AnyObject = SceneObject> {
  /** What is printed over what: zones, then strokes (1) and words (2) on the floor, then what stands on it (3). */
  readonly layer: 0 | 1 | 2 | 3;
  /**
   * An object as SVG, in mm of the picture, with presentation attributes only: office programs read no style sheets.
   * Simpler than on the screen (no shadows), with the same shapes, colours and signs.
   */
  svg(object: O, to: ToPicture, leastMm: number): string;
  /** What is put over the strokes. `leastMm`: no sign and no name is set in smaller type, in mm of the picture. */
  signSvg?(object: O, to: ToPicture, leastMm: number): string;
  /** Prints what lies on the floor. `shown`: what of the world the sheet shows. Left out: it stands on it. */
  pdf?(pdf: jsPDF, object: O, to: ToSheet, shown: Bounds): void;
}

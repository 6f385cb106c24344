import type { Vec } from '#core/geometry';
import { rotationRad } from '#core/angle';
import type { AnyObject } from '#scene/kinds/kind';
import type { Point, SceneObject } from '#scene/scene';

import type { Look } from '../look';
import type { Shape } from '../shapes';

/** Middle, direction and extent of an object that is no line. World mm. */
export interface Frame {
  readonly at: Vec;
  readonly angleRad: number;
  readonly size: Vec;
}

/** A kind of object as it looks at the start, on a screen and on paper: its layers from the floor up. */
export interface PictureKind<O extends AnyObject = SceneObject> {
  /** On the floor, under the lines. */
  ground?(object: O, look: Look): readonly Shape[];
  /** A line. */
  line?(object: O, look: Look): readonly Shape[];
  /** Over the lines. `isReached`: by the run. */
  sign?(object: O, look: Look, isReached?: boolean): readonly Shape[];
  /** On the floor, over lines and signs: words, the ways of what moves. `around`: the objects of its course, if known. */
  mark?(object: O, look: Look, around?: readonly SceneObject[]): readonly Shape[];
  /** The parts that stand on the floor. */
  body?(object: O, look: Look): readonly Shape[];
  /** The outline of what throws a shadow, filled. */
  shade?(object: O, fill: string): Shape;
  /** On paper true to scale, on which the real robot drives: thin lines where zones are. Left out: nothing of it lies on the floor. */
  paper?(object: O, look: Look): readonly Shape[];
  /** The turned rectangle around it, for the frame of the selection; `null`: it is a painted line. */
  frame(object: O): Frame | null;
}

/** The frame of a rectangle. */
export const boxFrame = ({ at: [x, y], size, angle }: Record<'at' | 'size', Point> & { angle: number }): Frame => ({
  at: { x, y },
  angleRad: rotationRad(angle),
  size: { x: size[0], y: size[1] },
});

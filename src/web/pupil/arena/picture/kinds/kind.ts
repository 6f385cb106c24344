import { rotationRad } from '#core/angle';
import type { Vec } from '#core/geometry';
import type { AnyObject } from '#scene/kinds/kind';
import type { SceneObject } from '#scene/scene';
import type { Verdict } from '#simulation/task/verdict';
import type { View } from '../../view/view-transform';
import type { Palette } from '../../model/palette';

/** Draws an object as it is at the start, in CSS px. */
type Draw<O> = (context: CanvasRenderingContext2D, view: View, object: O, palette: Palette) => void;

/** Middle, direction and extent of an object that is no line. World mm. */
export interface Frame {
  readonly at: Vec;
  readonly angleRad: number;
  readonly size: Vec;
}

/** What a sign tells of besides its object. */
export interface SignContext {
  readonly objects: readonly SceneObject[];
  readonly verdict: Verdict | null;
}

/**
 * A kind of object as it is drawn, from the floor up. The arena draws strokes, walls and blocks by themselves, since
 * they are many or move, and come with the first page: they have only `body`.
 */
export interface PictureKind<O extends AnyObject = SceneObject> {
  /** On the floor, under the strokes. */
  ground?(...given: Parameters<Draw<O>>): void;
  /** Over the strokes. */
  sign?(context: CanvasRenderingContext2D, view: View, object: O, palette: Palette, around: SignContext): void;
  /** On the floor, over strokes and signs: words, the ways of what moves. `around`: the objects of its course, if known. */
  mark?(
    context: CanvasRenderingContext2D,
    view: View,
    object: O,
    palette: Palette,
    around?: readonly SceneObject[],
  ): void;
  /** What stands and stays, like walls. */
  standing?(...given: Parameters<Draw<O>>): void;
  /** What has a layer of its own. */
  body?(...given: Parameters<Draw<O>>): void;
  /** What a frame is drawn around; `null`: it is a line. */
  frame(object: O): Frame | null;
}

/** The frame of a rectangle. */
export const boxFrame = ({ at: [x, y], size, angle }: Extract<SceneObject, { readonly size: unknown }>): Frame => ({
  at: { x, y },
  angleRad: rotationRad(angle),
  size: { x: size[0], y: size[1] },
});

import type { Vec } from '#core/geometry';
import { putPicture } from '../view/whole-pixels';
import { emptyCanvas } from './robot-sprite';

/** The look of a turned body: the same look is the same picture. */
export interface BodyLook {
  readonly headingRad: number;
  /** CSS px for one mm of the drawing. */
  readonly size: number;
  /** Canvas pixels per CSS px. */
  readonly ratio: number;
  /** Further values that it depends on, compared by identity. */
  readonly of: readonly unknown[];
}

/** Headings this close count as the same: the rim of a robot is then off by a tenth of a pixel. Chosen, in rad. */
const SAME_RAD = 0.002;

/**
 * A robot's body with shadow and lights, turned once and reused while its heading stays the same: without a graphics
 * card turning a picture and painting glows is most of the cost, and robots drive straight most of the time.
 */
export class TurnedBody {
  private last: BodyLook | null = null;
  private kept: HTMLCanvasElement | null = null;
  /** Number of frames in which it has looked the same. */
  private frames = 0;

  /**
   * @param patience number of unchanged frames before the picture is cached; differs between robots, as they may end a
   * turn together
   */
  constructor(private readonly patience = 0) {}

  /**
   * Draws the body.
   *
   * @param at the robot's place
   * @param reachPx how far `paint` reaches from there
   * @param paint draws the body in CSS px around the robot's place
   */
  draw(
    context: CanvasRenderingContext2D,
    at: Vec,
    reachPx: number,
    look: BodyLook,
    paint: (context: CanvasRenderingContext2D) => void,
  ): void {
    const isSame = this.last !== null && same(this.last, look);
    if (!isSame) [this.last, this.kept, this.frames] = [look, null, 0];
    else if (this.frames++ >= this.patience) this.kept ??= turned(reachPx, look.ratio, paint);
    if (this.kept !== null) {
      putPicture(context, this.kept, at);
      return;
    }
    context.save();
    context.translate(at.x, at.y);
    paint(context);
    context.restore();
  }
}

function same(a: BodyLook, b: BodyLook): boolean {
  return (
    Math.abs(a.headingRad - b.headingRad) < SAME_RAD &&
    a.size === b.size &&
    a.ratio === b.ratio &&
    a.of.length === b.of.length &&
    a.of.every((one, place) => one === b.of[place])
  );
}

function turned(
  reachPx: number,
  ratio: number,
  paint: (context: CanvasRenderingContext2D) => void,
): HTMLCanvasElement | null {
  const side = 2 * Math.ceil(reachPx * ratio);
  const canvas = emptyCanvas(side, side);
  const context = canvas.getContext('2d');
  if (context === null) return null;
  context.setTransform(ratio, 0, 0, ratio, side / 2, side / 2);
  paint(context);
  return canvas;
}

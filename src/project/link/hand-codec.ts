import type { Point } from '#scene/scene';

import type { Codec, Columns } from './codec';
import { joined } from './likelihood';
import { lineCodec } from './line-codec';

/**
 * The points of a line drawn by hand, for links with a model (`value-model.ts`): each as its step from the previous
 * one. A step is two whole numbers: its length along the axis to which the previous step was nearest, and its distance
 * to the left of the point to which that step would have led. Earlier steps say a lot about both: long straight pieces
 * tend to go on, and so does a bend to the left. So the last lengths and bends are the contexts.
 */
export function handCodec(columns: Columns, start: Codec<Point>): Codec<readonly Point[]> {
  const count = columns.uint();
  const [along, aside] = [columns.near(), columns.near()];
  return lineCodec(count, start, () => {
    const hand = new Hand();
    return {
      write(out, step) {
        const [ahead, left] = hand.seen(step);
        along.write(out, ahead, hand.nearAlong());
        aside.write(out, left, hand.nearAside(ahead));
        hand.goOn(step);
      },
      read(from) {
        const ahead = along.read(from, hand.nearAlong());
        const step = hand.unseen([ahead, aside.read(from, hand.nearAside(ahead))]);
        hand.goOn(step);
        return step;
      },
    };
  });
}

/** The present direction of a line and its history. */
class Hand {
  /** The previous step, in whole mm; its length is never zero. */
  private x = 1;
  private y = 0;
  /** Lengths of the last two steps. */
  private lengths: readonly [number, number] = [0, 0];
  /** Distances of the last two steps to the left of those before them, in mm. */
  private bends: readonly [number, number] = [0, 0];
  /** The sine of the last bend. */
  private sine = 0;

  /** A step relative to the line: distance ahead, and distance to the left of the expected point. */
  seen([x, y]: Point): Point {
    const ahead = this.isSteep ? y * this.sign : x * this.sign;
    return [ahead, this.side * ((this.isSteep ? x : y) - this.expected(ahead)) + 0];
  }

  /** The step with the relative form `seen`. Adding 0 avoids a negative zero. */
  unseen([ahead, left]: Point): Point {
    const [one, other] = [ahead * this.sign + 0, this.side * left + this.expected(ahead) + 0];
    return this.isSteep ? [other, one] : [one, other];
  }

  /** Contexts for the distance of the next step ahead. */
  nearAlong(): readonly number[] {
    const [last, before] = [sizeOf(this.lengths[0]), sizeOf(this.lengths[1])];
    const [bend, bendBefore] = [sizeOf(this.bends[0]), sizeOf(this.bends[1])];
    const both = joined(last, before);
    return [0, joined(1, last), joined(2, both), joined(joined(3, last), bend), joined(joined(4, both), joined(bend, bendBefore))]; // prettier-ignore
  }

  /** Contexts for the distance of the next step to the left, once its distance ahead is known. */
  nearAside(ahead: number): readonly number[] {
    const far = sizeOf(ahead);
    const [bend, bendBefore] = [sizeOf(this.bends[0]), sizeOf(this.bends[1])];
    const likely = sizeOf(Math.round(this.sine * Math.abs(ahead)));
    const signs = joined(Math.sign(bend), Math.sign(bendBefore));
    return [
      0,
      joined(1, far),
      joined(joined(2, far), likely),
      joined(joined(3, far), bend),
      joined(joined(4, far), joined(bend, bendBefore)),
      joined(joined(5, signs), joined(far, sizeOf(this.lengths[0]))),
    ];
  }

  /** Takes in a step; one of zero length changes nothing. */
  goOn([x, y]: Point): void {
    if (x === 0 && y === 0) return;
    const [length, lengthBefore] = [Math.sqrt(x * x + y * y), Math.sqrt(this.x * this.x + this.y * this.y)];
    const left = (this.x * y - this.y * x) / lengthBefore;
    this.lengths = [Math.round(length), this.lengths[0]];
    this.bends = [Math.round(left), this.bends[0]];
    this.sine = left / length;
    this.x = x;
    this.y = y;
  }

  private get isSteep(): boolean {
    return Math.abs(this.y) > Math.abs(this.x);
  }

  /** The direction of the line along its axis. */
  private get sign(): number {
    return (this.isSteep ? this.y : this.x) < 0 ? -1 : 1;
  }

  /** The direction of its left on the other axis. */
  private get side(): number {
    return this.isSteep ? -this.sign : this.sign;
  }

  private expected(ahead: number): number {
    return Math.round((this.isSteep ? this.x / Math.abs(this.y) : this.y / Math.abs(this.x)) * ahead);
  }
}

/** A length in mm as one of fourteen sizes, with its sign: lengths within a third of each other are alike. */
function sizeOf(mm: number): number {
  const length = Math.abs(mm);
  let size = 0;
  while (size < SIZES.length && length >= (SIZES[size] ?? 0)) size += 1;
  return mm < 0 ? -size : size;
}
const SIZES = [1, 2, 3, 4, 6, 9, 13, 19, 28, 40, 60, 90, 150];

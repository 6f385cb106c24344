import type { Fork, ForkType } from '../chassis';
import type { BlockBody, Holder } from './block-body';
import { isInside } from './convex';
import type { Body, Fixture } from './planck';
import { toUnits } from './scale';
import { Kind, Solid, toWorld } from './solid';
import type { Tool, ToolPlace } from './tool';

/**
 * A fork. When down, its plate slides under blocks. When up, it is solid to all, like the front of a real raised fork.
 * So a program must lower the fork before it can lift a block.
 */
export class ForkBody implements Fork, Tool, Holder {
  readonly body: Body;
  private readonly place: ToolPlace;
  private readonly plate: Solid;
  private readonly clearMm: number;
  private held: BlockBody[] = [];
  private height = 0;

  constructor(place: ToolPlace, type: ForkType) {
    this.place = place;
    this.body = place.body;
    this.clearMm = type.clearMm;
    this.plate = new Solid(this.body, type.plateMm.map(toUnits), Kind.tool);
    this.plate.meetsBlocks(false);
  }

  setHeightMm(heightMm: number): void {
    const wasUp = this.isUp();
    this.height = Math.max(heightMm, 0);
    if (this.isUp() === wasUp) return;
    this.plate.meetsBlocks(!wasUp);
    if (wasUp) this.release();
    else this.takeUp();
  }

  heightMm(): number {
    return this.height;
  }

  isHolding(): boolean {
    return this.held.some((block) => block.isHeldBy(this));
  }

  letGone(block: Fixture): void {
    this.place.expectTouch(block);
  }

  readonly remove = (): void => {
    this.release();
    this.plate.remove();
    this.place.drop(this);
  };

  solids(): readonly Solid[] {
    return [this.plate];
  }

  beforeStep(): void {
    // It acts only when it is moved.
  }

  blockPlaced(): void {
    if (this.isUp()) this.takeUp();
  }

  private isUp(): boolean {
    return this.height > this.clearMm;
  }

  private takeUp(): void {
    const plate = toWorld(this.body, this.plate.corners());
    for (const { block } of this.place.around.near([plate])) {
      if (!block?.isMovable || !isInside(plate, block.at())) continue;
      block.take(this);
      this.held.push(block);
    }
  }

  private release(): void {
    for (const block of this.held) if (block.isHeldBy(this)) block.release();
    this.held = [];
  }
}

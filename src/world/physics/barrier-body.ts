import type { Vec } from '#core/geometry';
import type { BarrierHandle } from '../shapes';
import { gapBetween } from './convex';
import { PolygonShape, type Vec2 } from './planck';
import type { Body, Fixture, PlanckWorld } from './planck';
import { toUnits } from './scale';
import { CONTACT_FRICTION } from './solid';
import type { Surroundings } from './surroundings';

/** A wall that is there while it is closed. It opens at once, and closes on nothing that stands in it. */
export class BarrierBody implements BarrierHandle {
  private readonly body: Body;
  private readonly corners: Vec2[];
  private fixture: Fixture | null = null;
  private wanted: 'open' | 'closed' = 'open';

  /** @param onGone called when a fixture has been taken out of the world */
  constructor(
    world: PlanckWorld,
    private readonly around: Surroundings,
    cornersMm: readonly Vec[],
    private readonly id: string | undefined,
    private readonly onGone: (fixture: Fixture) => void,
  ) {
    this.body = world.createBody();
    this.corners = cornersMm.map(toUnits);
  }

  get isOpen(): boolean {
    return this.fixture === null;
  }

  set(isOpen: boolean): void {
    this.wanted = isOpen ? 'open' : 'closed';
    if (isOpen) this.open();
    else this.beforeStep();
  }

  /** Closes once nothing stands in it any more. */
  beforeStep(): void {
    if (this.wanted === 'open' || this.fixture !== null || this.isBlocked()) return;
    const shape = new PolygonShape(this.corners);
    this.fixture = this.body.createFixture({ shape, friction: CONTACT_FRICTION, userData: this.id });
  }

  private open(): void {
    const { fixture } = this;
    if (fixture === null) return;
    this.fixture = null;
    this.body.destroyFixture(fixture);
    this.onGone(fixture);
  }

  private isBlocked(): boolean {
    return this.around
      .near([this.corners])
      .some(({ fixture, outline }) => !fixture.getBody().isStatic() && gapBetween(this.corners, outline).gap < 0);
  }
}

import type { Polygon } from './convex';
import type { BlockBody } from './block-body';
import type { Body, Fixture, PlanckWorld } from './planck';
import { outlineOf } from './solid';

/** A solid as it stands now. */
export interface Thing {
  readonly fixture: Fixture;
  /** World frame, units. */
  readonly outline: Polygon;
  /** The block, if it is movable and nothing holds it. */
  readonly block: BlockBody | null;
  /** Which of the block's parts it is; 0 for everything else. */
  readonly part: number;
}

/** The things around. */
export interface Surroundings {
  /** Everything solid that may reach into the box around these outlines (world frame, units), always in the same order. */
  near(outlines: readonly Polygon[]): Thing[];
}

/** Added to the searched box, in units; chosen: 1 mm. */
const MARGIN = 0.05;

/** Makes the search in an engine's world. */
export function createSurroundings(world: PlanckWorld, blocks: ReadonlyMap<Body, BlockBody>): Surroundings {
  return {
    near(outlines) {
      const lowerBound = { x: Infinity, y: Infinity };
      const upperBound = { x: -Infinity, y: -Infinity };
      for (const outline of outlines) {
        for (const { x, y } of outline) {
          lowerBound.x = Math.min(lowerBound.x, x - MARGIN);
          lowerBound.y = Math.min(lowerBound.y, y - MARGIN);
          upperBound.x = Math.max(upperBound.x, x + MARGIN);
          upperBound.y = Math.max(upperBound.y, y + MARGIN);
        }
      }
      const things: Thing[] = [];
      world.queryAABB({ lowerBound, upperBound }, (fixture) => {
        const found = blocks.get(fixture.getBody());
        const block = found?.isMovable ? found : null;
        things.push({ fixture, outline: outlineOf(fixture), block, part: block?.fixtures.indexOf(fixture) ?? 0 });
        return true;
      });
      return things;
    },
  };
}

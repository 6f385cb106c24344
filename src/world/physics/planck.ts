/**
 * The physics engine (planck 1.5.0, MIT), with exact trigonometry inside. The only file that imports it.
 * The order of these three imports is the whole point: see `./lend-exact-trig`.
 */
import './lend-exact-trig';
import { Joint, PolygonShape, Rot, Vec2, World } from 'planck';
import './return-exact-trig';

// Only the exact sine is undefined this far out. This detects at once a bundler that changed the order.
if (!Number.isNaN(new Rot(1e9).s)) {
  throw new Error(
    'The physics engine was loaded before the exact trigonometry; check the order of modules in the bundle.',
  );
}

export type { Body, Contact, Fixture, TimeStep } from 'planck';
export { Joint, PolygonShape, Rot, Vec2, World as PlanckWorld };

/**
 * The physics engine (planck 1.5.0, MIT), with exact trigonometry inside. The only file that imports it.
 * The order of these three imports is the whole point: see `./lend-exact-trig`.
 */
import './lend-exact-trig';
import { CircleShape, Joint, PolygonShape, Rot, Settings, Vec2, World } from 'planck';
import './return-exact-trig';

// Only the exact sine is undefined this far out. This detects at once a bundler that changed the order.
if (!Number.isNaN(new Rot(1e9).s)) {
  throw new Error(
    'The physics engine was loaded before the exact trigonometry; check the order of modules in the bundle.',
  );
}

export type { Body, Contact, Fixture, TimeStep } from 'planck';
// Of 12, which is the engine's own choice, an ellipse would be a die. A course's polygons have up to 60 corners.
Settings.maxPolygonVertices = 64;

export { CircleShape, Joint, PolygonShape, Rot, Settings, Vec2, World as PlanckWorld };

import { PolygonShape } from './planck';
import type { Body, Fixture } from './planck';

interface Point {
  readonly x: number;
  readonly y: number;
}
interface Box {
  readonly lowerBound: Point;
  readonly upperBound: Point;
}
interface Placed {
  readonly p: Point;
  readonly q: { readonly s: number; readonly c: number };
}

/** Members of a fixture through which planck 1.5.0 updates its box in the search for contacts. */
interface Synchronized {
  readonly m_proxies: readonly { readonly aabb: Box; readonly proxyId: number }[];
  synchronize(broadPhase: Boxes, from: Placed, to: Placed): void;
}
interface Boxes {
  /** The box that stands for a fixture in the search for contacts: somewhat wider than it, and left alone until it leaves it. */
  getFatAABB(proxyId: number): Box;
}

/** For rounding, in units: far above it, and far below everything else. */
const SURE = 1e-6;

/**
 * Skips the search for contacts of a body's convex outlines, which keep their shape, while they cannot have left the
 * wide box that the engine has for them. It would compute two boxes a step and outline and find nothing to do.
 */
export function skipWhileNear(body: Body): void {
  for (let fixture = body.getFixtureList(); fixture; fixture = fixture.getNext()) skip(fixture);
}

function skip(fixture: Fixture): void {
  const own = fixture as unknown as Synchronized;
  const synchronize = own.synchronize.bind(fixture);
  const farthest = farthestCorner(fixture);
  // Where it was last asked, and how far it may move from there along each axis.
  const last = { x: NaN, y: NaN, c: 1, s: 0 };
  let roomX = 0;
  let roomY = 0;
  const isNear = ({ p, q }: Placed): boolean => {
    const turned = farthest * (Math.abs(q.c - last.c) + Math.abs(q.s - last.s));
    return Math.abs(p.x - last.x) + turned < roomX && Math.abs(p.y - last.y) + turned < roomY;
  };
  own.synchronize = (boxes, from, to) => {
    if (isNear(from) && isNear(to)) return;
    synchronize(boxes, from, to);
    const [proxy] = own.m_proxies;
    if (!proxy) return;
    const { lowerBound: low, upperBound: high } = proxy.aabb;
    const wide = boxes.getFatAABB(proxy.proxyId);
    roomX = Math.min(low.x - wide.lowerBound.x, wide.upperBound.x - high.x) - SURE;
    roomY = Math.min(low.y - wide.lowerBound.y, wide.upperBound.y - high.y) - SURE;
    last.x = to.p.x;
    last.y = to.p.y;
    last.c = to.q.c;
    last.s = to.q.s;
  };
}

/** Distance of a fixture's farthest corner from the middle of its body, units. */
function farthestCorner(fixture: Fixture): number {
  const shape = fixture.getShape();
  if (!(shape instanceof PolygonShape)) return Infinity;
  return Math.max(...shape.m_vertices.map(({ x, y }) => Math.sqrt(x * x + y * y)));
}

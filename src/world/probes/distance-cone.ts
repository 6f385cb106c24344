import { exactCos, exactSin, exactTan } from '#core/exact-math';
import type { Pose, Vec } from '#core/geometry';
import type { Shares } from '../shapes';

/** The beam of a distance sensor. */
export interface Cone {
  /** Full opening angle, 0 … under π. */
  readonly openingRad: number;
  readonly rangeMm: number;
  /** Height of the sensor above the floor: what ends below it is not heard. Left out: everything is. */
  readonly heightMm?: number;
  /** Surfaces turned away from the middle of the beam by more than this reflect nothing; left out: all reflect. */
  readonly incidenceLimitRad?: number;
}

/** The result of a distance sensor. */
export interface ConeHit {
  /** Distance to the nearest point in the cone, or `Infinity` if nothing is in range. */
  readonly distanceMm: number;
  /** That point, or `null`. */
  readonly hitMm: Vec | null;
}

/** A solid that a beam can meet. */
export interface Obstacle {
  /** Convex outline, counter-clockwise, about its own origin, mm; none: the circle of `radiusMm` around the origin. */
  readonly cornersMm: readonly Vec[];
  /** Distance of the farthest corner from the origin, mm. */
  readonly radiusMm: number;
  /** Its top above the floor; `Infinity`: endlessly high. */
  readonly heightMm: number;
  /** Its colour; left out: none. */
  readonly shares?: Shares;
  pose(): Pose;
}

/** Rays of a beam with an incidence limit lie this far apart. Chosen: finds a flat wall at 2 m within 0.1 mm. */
const RAY_STEP_RAD = 0.00872664625997165; // 0.5°

/** An edge that faces the sensor, from (ax, ay) to (bx, by) in the beam's frame: sensor at the origin, looking along x. */
interface Edge {
  readonly ax: number;
  readonly ay: number;
  readonly bx: number;
  readonly by: number;
}

/** A circle in the beam's frame. */
interface Circle {
  readonly x: number;
  readonly y: number;
  readonly radius: number;
}

/** The things that a beam can meet, in its own frame. */
interface Met {
  readonly edges: Edge[];
  readonly circles: Circle[];
}

const NOTHING: ConeHit = { distanceMm: Infinity, hitMm: null };

/** Makes an obstacle that stays where its corners are. */
export function stillObstacle(cornersMm: readonly Vec[], heightMm = Infinity): Obstacle {
  const first = cornersMm[0] ?? { x: 0, y: 0 };
  const pose: Pose = { xMm: first.x, yMm: first.y, headingRad: 0 };
  return movingObstacle(
    cornersMm.map((corner) => ({ x: corner.x - first.x, y: corner.y - first.y })),
    () => pose,
    heightMm,
  );
}

/** Makes an obstacle from its outline and a function that gives its pose. */
export function movingObstacle(cornersMm: readonly Vec[], pose: () => Pose, heightMm = Infinity): Obstacle {
  let radiusMm = 0;
  for (const { x, y } of cornersMm) radiusMm = Math.max(radiusMm, Math.sqrt(x * x + y * y));
  return { cornersMm, radiusMm, heightMm, pose };
}

/**
 * The nearest point of all obstacles inside a cone. Without an incidence limit it is computed exactly, not by rays:
 * nothing can hide the nearest point. With a limit, rays 0.5° apart are traced, and surfaces turned away too far hide
 * what is behind them.
 */
export function nearestInCone(from: Vec, headingRad: number, cone: Cone, obstacles: Iterable<Obstacle>): ConeHit {
  const halfRad = cone.openingRad / 2;
  const slope = exactTan(halfRad);
  const cos = exactCos(headingRad);
  const sin = exactSin(headingRad);
  const met: Met = { edges: [], circles: [] };
  const { heightMm = 0 } = cone;
  for (const obstacle of obstacles) {
    if (obstacle.heightMm < heightMm) continue;
    if (gather(obstacle, from, cos, sin, cone.rangeMm, met)) return { distanceMm: 0, hitMm: from };
  }
  const hit =
    cone.incidenceLimitRad === undefined
      ? nearer(nearestPoint(met.edges, slope), nearestOfCircles(met.circles, halfRad, slope))
      : nearestEcho(met, halfRad, exactCos(cone.incidenceLimitRad));
  const distanceMm = Math.sqrt(hit.x * hit.x + hit.y * hit.y);
  if (!(distanceMm <= cone.rangeMm)) return NOTHING;
  return { distanceMm, hitMm: { x: from.x + hit.x * cos - hit.y * sin, y: from.y + hit.x * sin + hit.y * cos } };
}

/** Adds an obstacle in the beam's frame if it can be in range; true if the sensor is inside the obstacle. */
function gather(obstacle: Obstacle, from: Vec, cos: number, sin: number, rangeMm: number, met: Met): boolean {
  const pose = obstacle.pose();
  const x = (pose.xMm - from.x) * cos + (pose.yMm - from.y) * sin;
  const y = (pose.yMm - from.y) * cos - (pose.xMm - from.x) * sin;
  const reach = rangeMm + obstacle.radiusMm;
  if (x * x + y * y > reach * reach || x < -obstacle.radiusMm) return false;
  const corners = obstacle.cornersMm;
  const last = corners[corners.length - 1];
  if (last === undefined) {
    const { radiusMm: radius } = obstacle;
    met.circles.push({ x, y, radius });
    return x * x + y * y <= radius * radius;
  }
  // Own heading in the beam's frame.
  const ownCos = pose.headingRad === 0 ? 1 : exactCos(pose.headingRad);
  const ownSin = pose.headingRad === 0 ? 0 : exactSin(pose.headingRad);
  const turnCos = ownCos * cos + ownSin * sin;
  const turnSin = ownSin * cos - ownCos * sin;
  let ax = x + last.x * turnCos - last.y * turnSin;
  let ay = y + last.x * turnSin + last.y * turnCos;
  let inside = true;
  for (const corner of corners) {
    const bx = x + corner.x * turnCos - corner.y * turnSin;
    const by = y + corner.x * turnSin + corner.y * turnCos;
    const side = ax * by - ay * bx;
    if (side < 0) {
      inside = false; // the sensor sees this edge from outside
      met.edges.push({ ax, ay, bx, by });
    }
    ax = bx;
    ay = by;
  }
  return inside;
}

/** The point nearest to the origin among the parts of the edges with |y| ≤ slope · x; far away if there is none. */
function nearestPoint(edges: readonly Edge[], slope: number): Vec {
  let bestX = Infinity;
  let bestY = 0;
  let best = Infinity;
  for (const { ax, ay, bx, by } of edges) {
    const dx = bx - ax;
    const dy = by - ay;
    // Share of the edge, from low to high, that lies inside both sides of the beam and ahead of the sensor.
    let low = 0;
    let high = 1;
    for (let side = 0; side < 3 && low <= high; side++) {
      const atA = side === 0 ? slope * ax - ay : side === 1 ? slope * ax + ay : ax;
      const atB = side === 0 ? slope * bx - by : side === 1 ? slope * bx + by : bx;
      if (atA < 0 && atB < 0) high = -1;
      else if (atA < 0) low = Math.max(low, atA / (atA - atB));
      else if (atB < 0) high = Math.min(high, atA / (atA - atB));
    }
    if (low > high) continue;
    const foot = -(ax * dx + ay * dy) / (dx * dx + dy * dy);
    const share = Math.min(Math.max(foot, low), high);
    const x = ax + share * dx;
    const y = ay + share * dy;
    if (x * x + y * y < best) {
      best = x * x + y * y;
      bestX = x;
      bestY = y;
    }
  }
  return { x: bestX, y: bestY };
}

const FAR: Vec = { x: Infinity, y: 0 };

const nearer = (a: Vec, b: Vec): Vec => (b.x * b.x + b.y * b.y < a.x * a.x + a.y * a.y ? b : a);

/**
 * The point nearest to the origin among the parts of circles within the beam; far away if there is none. It lies towards
 * the circle's middle, or, when that is outside of the beam, on the side of the beam that is nearer to it.
 */
function nearestOfCircles(circles: readonly Circle[], halfRad: number, slope: number): Vec {
  const [cos, sin] = [exactCos(halfRad), exactSin(halfRad)];
  return circles.reduce((best, circle) => {
    const { x, y, radius } = circle;
    const length = Math.sqrt(x * x + y * y);
    if (x > 0 && Math.abs(y) <= slope * x) return nearer(best, { x: x - (x / length) * radius, y: y - (y / length) * radius }); // prettier-ignore
    const side = y < 0 ? -sin : sin;
    const along = wayToCircle(circle, cos, side);
    return along === Infinity ? best : nearer(best, { x: along * cos, y: along * side });
  }, FAR);
}

/** How far it is along a ray from the origin to a circle that the origin is outside of; `Infinity`: it does not meet it. */
function wayToCircle({ x, y, radius }: Circle, cos: number, sin: number): number {
  const along = x * cos + y * sin;
  const across = y * cos - x * sin;
  const half = radius * radius - across * across;
  return along > 0 && half >= 0 ? along - Math.sqrt(half) : Infinity;
}

/** The nearest point where a ray meets a surface that is not turned away too far; far away if there is none. */
function nearestEcho({ edges, circles }: Met, halfRad: number, steepCos: number): Vec {
  const raysPerSide = Math.ceil(halfRad / RAY_STEP_RAD);
  let bestDistance = Infinity;
  let best: Vec = { x: Infinity, y: 0 };
  for (let ray = -raysPerSide; ray <= raysPerSide; ray++) {
    const angleRad = raysPerSide === 0 ? 0 : (halfRad * ray) / raysPerSide;
    const cos = exactCos(angleRad);
    const sin = exactSin(angleRad);
    let distance = Infinity;
    let steepness = 0;
    for (const { ax, ay, bx, by } of edges) {
      const dx = bx - ax;
      const dy = by - ay;
      const across = cos * dy - sin * dx;
      if (across === 0) continue;
      const along = (ax * dy - ay * dx) / across;
      const share = (ax * sin - ay * cos) / across;
      if (share < 0 || share > 1 || along <= 0 || along >= distance) continue;
      distance = along;
      steepness = Math.abs(dy) / Math.sqrt(dx * dx + dy * dy);
    }
    for (const circle of circles) {
      const along = wayToCircle(circle, cos, sin);
      if (along >= distance) continue;
      distance = along;
      steepness = Math.abs(along * cos - circle.x) / circle.radius;
    }
    if (steepness >= steepCos && distance < bestDistance) {
      bestDistance = distance;
      best = { x: distance * cos, y: distance * sin };
    }
  }
  return best;
}

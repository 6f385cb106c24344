import { exactCos, exactSin } from '#core/exact-math';
import type { Pose, Vec } from '#core/geometry';
import type { Shares } from '../shapes';
import type { Obstacle } from './distance-cone';

/**
 * The view of a camera: a pinhole whose axis looks ahead and down. Its picture is cut into cells, whose middles it looks
 * through; places in the picture are shares of it, 0 … 1 from the left and from the top.
 */
export interface CameraView {
  /** Height of the lens above the floor. */
  readonly heightMm: number;
  /** Angle of its axis below the horizon, 0 … under π/2. */
  readonly tiltRad: number;
  /** Tangents of half of its field of view. */
  readonly acrossTan: number;
  readonly uprightTan: number;
  readonly columns: number;
  readonly rows: number;
  /** Farther along the floor it sees nothing. */
  readonly rangeMm: number;
}

/** The sight of one cell. */
export interface CameraCell {
  /** Shares of light, each 1 for bare floor; of what has no colour `null`. */
  readonly shares: Shares | null;
  readonly isFloor: boolean;
}

/** A place of the picture. */
export interface PicturePlace {
  readonly x: number;
  readonly y: number;
}

/** A tag, a printed pattern that cameras recognise. */
export interface TagShape {
  readonly number: number;
  /**
   * Its place now: the middle of its lower edge and the direction of its printed side if it stands, its middle and its turn
   * if it lies.
   */
  readonly pose: () => Pose;
  /** Side of its black square. */
  readonly sideMm: number;
  /** Width of the white rim around it. */
  readonly rimMm: number;
  readonly isFlat: boolean;
}

/** A tag in the picture. */
export interface SeenTag {
  readonly number: number;
  /** Corners of its black square. */
  readonly corners: readonly PicturePlace[];
}

/** Everything that a camera can see. */
export interface Sights {
  readonly obstacles: Iterable<Obstacle>;
  /** Shares of light of the floor at a place; `null`: outside of the arena. */
  readonly floor: (place: Vec) => Shares | null;
  readonly tags: Iterable<TagShape>;
}

/** A place in the camera's frame: depth along the floor, y to the left, z up. */
interface Place3 {
  readonly x: number;
  readonly y: number;
  readonly z: number;
}

/** An obstacle in the camera's frame. */
interface Thing {
  readonly corners: readonly Vec[];
  readonly middle: Vec;
  /** That of a circle; 0: it has corners. */
  readonly radius: number;
  readonly heightMm: number;
  readonly shares: Shares | null;
  /** Rays outside of these slopes pass it. */
  readonly right: number;
  readonly left: number;
}

const NOTHING: CameraCell = { shares: null, isFloor: false };

/** A tag may lie so deep in what it is stuck to: chosen, half of a thick wall. */
const STUCK_MM = 15;
/** Tags that are turned away more than that, or whose edges are shorter in the picture, are not recognised. Chosen. */
const LEAST_FACING = 0.35; // cosine of 70°
const LEAST_EDGE = 0.055; // of the picture's width: 18 of 320 px, more than two for each of its eight cells

/** A camera at a place. */
export interface Camera {
  /** The cells of these rows (from the top; left out: all), row by row from the left. */
  picture(rows?: readonly number[]): readonly (readonly CameraCell[])[];
  /** The tags that it recognises. */
  tags(): readonly SeenTag[];
  /**
   * For each of these slopes (mm to the left per mm of depth) the depth up to which the floor is in sight, at most `toMm`: a
   * thing that hides the place there ends it.
   */
  floorEnds(slopes: readonly number[], toMm: number): readonly number[];
}

/** A camera whose lens is above `from` and looks along `headingRad`. */
export function cameraAt(from: Vec, headingRad: number, view: CameraView, sights: Sights): Camera {
  const [cos, sin] = [exactCos(headingRad), exactSin(headingRad)];
  const into = (place: Vec): Vec => ({
    x: (place.x - from.x) * cos + (place.y - from.y) * sin,
    y: (place.y - from.y) * cos - (place.x - from.x) * sin,
  });
  const tilt = { cos: exactCos(view.tiltRad), sin: exactSin(view.tiltRad) };
  const things = [...sights.obstacles].flatMap((obstacle) => thingOf(obstacle, into, headingRad, view));
  const floorAt = (x: number, slope: number): CameraCell => {
    const y = x * slope;
    const shares = sights.floor({ x: from.x + x * cos - y * sin, y: from.y + x * sin + y * cos });
    return shares === null ? NOTHING : { shares, isFloor: true };
  };
  const look = (slope: number, rise: number): CameraCell => {
    const floorMm = rise < 0 ? view.heightMm / -rise : Infinity;
    let bestMm = Math.min(floorMm, view.rangeMm);
    let best: Thing | null = null;
    for (const thing of things) {
      if (slope < thing.right || slope > thing.left) continue;
      const metMm = meets(thing, slope, rise, view.heightMm);
      if (metMm < bestMm) [bestMm, best] = [metMm, thing];
    }
    if (best !== null) return { shares: best.shares, isFloor: false };
    return floorMm <= view.rangeMm ? floorAt(floorMm, slope) : NOTHING;
  };
  const row = (number: number): CameraCell[] => {
    const v = view.uprightTan * (1 - (2 * number + 1) / view.rows);
    const forward = tilt.cos + v * tilt.sin;
    const rise = (v * tilt.cos - tilt.sin) / forward;
    return Array.from({ length: view.columns }, (_, column) =>
      look((view.acrossTan * (1 - (2 * column + 1) / view.columns)) / forward, rise),
    );
  };
  const isHidden = ({ x, y, z }: Place3): boolean =>
    things.some((thing) => meets(thing, y / x, (z - view.heightMm) / x, view.heightMm) < x - STUCK_MM);

  return {
    picture: (rows) => (rows ?? Array.from({ length: view.rows }, (_, number) => number)).map(row),
    tags: () =>
      [...sights.tags].flatMap((tag) => {
        const pose = tag.pose();
        const spots = spotsOf(tag, into({ x: pose.xMm, y: pose.yMm }), pose.headingRad - headingRad, view);
        const corners = spots.map((spot) => project(spot, view, tilt)).filter((place) => place !== null);
        const isSeen = corners.length === 4 && isLargeEnough(corners, view) && !spots.some(isHidden);
        return isSeen ? [{ number: tag.number, corners }] : [];
      }),
    floorEnds: (slopes, toMm) =>
      slopes.map((slope) =>
        Math.min(toMm, ...things.map((thing) => meets(thing, slope, view.heightMm / -toMm, view.heightMm))),
      ),
  };
}

/** The place of a point in the picture; `null`: it is outside. */
function project(
  { x, y, z }: Place3,
  { heightMm, acrossTan, uprightTan }: CameraView,
  { cos, sin }: { readonly cos: number; readonly sin: number },
): PicturePlace | null {
  const up = z - heightMm;
  const depth = x * cos - up * sin;
  if (depth <= 0) return null;
  const across = y / depth / acrossTan;
  const above = (x * sin + up * cos) / depth / uprightTan;
  return Math.abs(across) > 1 || Math.abs(above) > 1 ? null : { x: (1 - across) / 2, y: (1 - above) / 2 };
}

/** The corners of a tag's black square in the camera's frame; none: it is behind the camera, too far or turned away. */
function spotsOf(tag: TagShape, at: Vec, turnRad: number, { rangeMm }: CameraView): readonly Place3[] {
  if (at.x <= 0 || at.x > rangeMm) return [];
  const facing = { x: exactCos(turnRad), y: exactSin(turnRad) };
  const isAway = -(facing.x * at.x + facing.y * at.y) < LEAST_FACING * Math.sqrt(at.x * at.x + at.y * at.y);
  return isAway && !tag.isFlat ? [] : cornersOf(tag, at, facing);
}

/** An obstacle in the camera's frame, if it can be in the picture. */
function thingOf(obstacle: Obstacle, into: (place: Vec) => Vec, headingRad: number, view: CameraView): Thing[] {
  const { cornersMm, radiusMm, heightMm, shares = null } = obstacle;
  const pose = obstacle.pose();
  const middle = into({ x: pose.xMm, y: pose.yMm });
  if (middle.x < -radiusMm || middle.x > view.rangeMm + radiusMm) return [];
  // Wider than the field at the edge of a picture that looks down, which is at most 2.4 times as wide.
  if (Math.abs(middle.y) - 2 * radiusMm > 2.4 * view.acrossTan * (Math.max(middle.x, 0) + radiusMm)) return [];
  const turn = pose.headingRad - headingRad;
  const [cos, sin] = [exactCos(turn), exactSin(turn)];
  const corners = cornersMm.map(({ x, y }) => ({
    x: middle.x + x * cos - y * sin,
    y: middle.y + x * sin + y * cos,
  }));
  const radius = corners.length === 0 ? radiusMm : 0;
  return [{ corners, middle, radius, heightMm, shares, ...slopesOf(radius > 0 ? around(middle, radius) : corners) }];
}

/** The corners of the square around a circle. */
const around = ({ x, y }: Vec, radius: number): readonly Vec[] =>
  [-radius, radius].flatMap((dx) => [-radius, radius].map((dy) => ({ x: x + dx, y: y + dy })));

/** The slopes between which a ray can meet a convex outline; of one that reaches behind the lens all. */
function slopesOf(corners: readonly Vec[]): Pick<Thing, 'right' | 'left'> {
  let [right, left] = [Infinity, -Infinity];
  for (const { x, y } of corners) {
    if (x <= 1) return { right: -Infinity, left: Infinity };
    right = Math.min(right, y / x);
    left = Math.max(left, y / x);
  }
  return { right, left };
}

/** The depth at which a ray meets a thing; `Infinity`: it does not. It rises by `rise` per mm of depth. */
function meets(thing: Thing, slope: number, rise: number, lensMm: number): number {
  let nearMm = 0;
  let farMm = Infinity;
  if (thing.radius > 0) {
    const { middle, radius } = thing;
    const squared = 1 + slope * slope;
    const along = (middle.x + slope * middle.y) / squared;
    const half = along * along - (middle.x * middle.x + middle.y * middle.y - radius * radius) / squared;
    if (half <= 0) return Infinity;
    const root = Math.sqrt(half);
    [nearMm, farMm] = [Math.max(along - root, 0), along + root];
  } else {
    let a = thing.corners[thing.corners.length - 1] ?? { x: 0, y: 0 };
    for (const b of thing.corners) {
      const [dx, dy] = [b.x - a.x, b.y - a.y];
      // Inside is where grows · x + before ≥ 0.
      const grows = dx * slope - dy;
      const before = dy * a.x - dx * a.y;
      if (grows > 0) nearMm = Math.max(nearMm, -before / grows);
      else if (grows < 0) farMm = Math.min(farMm, -before / grows);
      else if (before < 0) return Infinity;
      a = b;
    }
  }
  if (nearMm >= farMm) return Infinity;
  const top = thing.heightMm;
  // A falling ray passes above a low thing until it is down at its top; a rising ray that is above never comes back.
  const metMm = rise < 0 ? Math.max(nearMm, (lensMm - top) / -rise) : nearMm;
  return metMm < farMm && (rise < 0 || lensMm + rise * metMm <= top) ? metMm : Infinity;
}

/** The corners of a tag's black square in the camera's frame, around. */
function cornersOf({ sideMm, rimMm, isFlat }: TagShape, { x, y }: Vec, facing: Vec): readonly Place3[] {
  const half = sideMm / 2;
  const square = [[-half, half], [half, half], [half, -half], [-half, -half]] as const; // prettier-ignore
  return square.map(([right, up]) =>
    isFlat
      ? { x: x + right * facing.x - up * facing.y, y: y + right * facing.y + up * facing.x, z: 0 }
      : { x: x - right * facing.y, y: y + right * facing.x, z: rimMm + half + up },
  );
}

/** True if each edge of a square is long enough in the picture. */
function isLargeEnough(corners: readonly PicturePlace[], { acrossTan, uprightTan }: CameraView): boolean {
  const flat = uprightTan / acrossTan;
  return corners.every(({ x, y }, place) => {
    const next = corners[(place + 1) % corners.length] ?? { x, y };
    const [across, down] = [next.x - x, (next.y - y) * flat];
    return across * across + down * down >= LEAST_EDGE * LEAST_EDGE;
  });
}

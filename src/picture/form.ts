import type { Vec } from '#core/geometry';
import { lastMadeOf } from '#core/memo';
import { distanceToEdge, lengthOf, type Outline } from '#scene/outline';
import type { PaintColor, Painted } from '#scene/paint/paint';
import type { Point, Shaped } from '#scene/scene';
import { outlineHolds, ownOutline } from '#scene/shape/shape';

import type { Geometry } from './shapes';

/** A rectangle, an ellipse or a polygon, about its middle. */
export interface Form {
  readonly sizeMm: Vec;
  readonly round?: boolean | undefined;
  readonly corners?: readonly Point[] | undefined;
  /** Left out: without a colour of its own. */
  readonly color?: PaintColor | undefined;
}

/** The form of an object. */
export const formOf = ({
  size,
  round,
  corners,
  color,
}: Pick<Shaped, 'size' | 'round' | 'corners'> & Painted): Form => ({
  ...{ sizeMm: { x: size[0], y: size[1] }, round, corners },
  ...(color && { color }),
});

/** The outline of a form as it is drawn, y down; that of an ellipse has straight pieces. */
export const outlineOf = ({ sizeMm, round = false, corners }: Form): Outline =>
  ownOutline({ size: [sizeMm.x, sizeMm.y], round, ...(corners && { corners }) }).map(({ x, y }) => ({ x, y: -y }));

/** The corners of a polygon as they are drawn, y down; each edge moved inward (less than 0: outward). */
export const polygonPath = ({ sizeMm, corners = [] }: Form, insetMm = 0): Outline =>
  inset(outlineOf({ sizeMm, corners }), insetMm);

/** A pointed corner moves at most so many times as far as its edges. Chosen: it stays beside its corner. */
const FARTHEST = 3;

/** An outline that goes round clockwise as it is seen, y down, with each edge moved inward. */
export function inset(outline: Outline, mm: number): Outline {
  if (mm === 0) return outline;
  return outline.map((corner, index) => {
    const one = inward(outline[(index + outline.length - 1) % outline.length] ?? corner, corner);
    const other = inward(corner, outline[(index + 1) % outline.length] ?? corner);
    const [x, y] = [one.x + other.x, one.y + other.y];
    const times = Math.min(FARTHEST, 2 / Math.max(0.1, x * x + y * y)) * mm;
    return { x: corner.x + x * times, y: corner.y + y * times };
  });
}

function inward(from: Vec, to: Vec): Vec {
  const [dx, dy] = [to.x - from.x, to.y - from.y];
  const length = lengthOf(dx, dy) || 1;
  return { x: dy / length, y: -dx / length };
}

/** Places as pairs. */
export const pairs = (outline: Outline): readonly Point[] => outline.map(({ x, y }) => [x, y]);

/** A form as it is drawn, its edges moved inward. `radius`: of a rectangle's corners. */
export function geometryOf(form: Form, insetMm: number, radius: number): Geometry {
  if (form.corners) return { form: 'lines', lines: [pairs(polygonPath(form, insetMm))], isClosed: true };
  const size: Point = [Math.max(1, form.sizeMm.x - 2 * insetMm), Math.max(1, form.sizeMm.y - 2 * insetMm)];
  const half: Point = [size[0] / 2, size[1] / 2];
  return form.round === true
    ? { form: 'ellipse', at: [0, 0], radii: half }
    : { form: 'rect', at: [-half[0], -half[1]], size, round: radius };
}

/** Stripes at 45° across a form, cut off at its edges: `first` is x + y in the middle of one of them. */
export function stripes(form: Form, { first, pitch, width }: Record<'first' | 'pitch' | 'width', number>): Geometry {
  const outline = outlineOf(form);
  const most = (form.sizeMm.x + form.sizeMm.y) / 2;
  const half = (width / 2) * Math.SQRT2;
  const lines: (readonly Point[])[] = [];
  for (let middle = first; middle - half < most; middle += pitch) {
    const above = cut(outline, (sum) => sum - middle + half);
    const stripe = cut(above, (sum) => middle + half - sum);
    if (stripe.length > 2) lines.push(pairs(stripe));
  }
  return { form: 'lines', lines, isClosed: true };
}

/** The part of an outline on the side of a diagonal where `far`, of x + y, is not below 0. */
function cut(outline: Outline, far: (sum: number) => number): Outline {
  const kept: Vec[] = [];
  let from = outline[outline.length - 1] ?? { x: 0, y: 0 };
  let before = far(from.x + from.y);
  for (const to of outline) {
    const here = far(to.x + to.y);
    const share = before / (before - here);
    if (before < 0 !== here < 0)
      kept.push({ x: from.x + share * (to.x - from.x), y: from.y + share * (to.y - from.y) });
    if (here >= 0) kept.push(to);
    from = to;
    before = here;
  }
  return kept;
}

/** The room for a sign in a form, y down, and its width there. mm. */
export interface Room {
  readonly at: Vec;
  readonly acrossMm: number;
}

/** Places that are tried along each axis of a polygon. Chosen: near enough to the best by eye. */
const TRIED = 16;

/** The place in a form with the most room around it: of a rectangle and an ellipse the middle. */
export function signRoomIn(form: Form): Room {
  const { sizeMm, corners } = form;
  if (!corners) return { at: { x: 0, y: 0 }, acrossMm: Math.min(sizeMm.x, sizeMm.y) };
  return roomInPolygon(corners, sizeMm);
}

const roomInPolygon = lastMadeOf(freestPlace, (one, other) => one.x === other.x && one.y === other.y);

function freestPlace(corners: readonly Point[], sizeMm: Vec): Room {
  const outline = polygonPath({ corners, sizeMm });
  let room: Room = { at: { x: 0, y: 0 }, acrossMm: 0 };
  for (let i = 0; i < TRIED * TRIED; i++) {
    const [column, row] = [i % TRIED, Math.floor(i / TRIED)];
    const at = { x: ((column + 0.5) / TRIED - 0.5) * sizeMm.x, y: ((row + 0.5) / TRIED - 0.5) * sizeMm.y };
    const acrossMm = outlineHolds(outline, at, 0) ? 2 * distanceToEdge(outline, at) : 0;
    if (acrossMm > room.acrossMm) room = { at, acrossMm };
  }
  return room;
}

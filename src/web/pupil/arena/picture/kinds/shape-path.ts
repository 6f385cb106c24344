import type { Vec } from '#core/geometry';
import { distanceToEdge, type Outline } from '#scene/outline';
import type { Point, Shaped } from '#scene/scene';
import { outlineHolds, ownOutline } from '#scene/shape/shape';
import { lastMadeOf } from '../../../../kit/state/memo';
import type { Form } from '../../model/arena-model';

/** The form of an object. */
export const formOf = ({ size, round, corners }: Pick<Shaped, 'size' | 'round' | 'corners'>): Form => ({
  ...{ sizeMm: { x: size[0], y: size[1] }, round, corners },
});

/** The corners of a polygon as they are drawn, y down; each edge moved inward (less than 0: outward). */
export function polygonPath({ sizeMm, corners = [] }: Form, insetMm = 0): Outline {
  return inset(
    ownOutline({ size: [sizeMm.x, sizeMm.y], corners }).map(({ x, y }) => ({ x, y: -y })),
    insetMm,
  );
}

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
  const length = Math.hypot(dx, dy) || 1;
  return { x: dy / length, y: -dx / length };
}

/** Begins a path around a form about the origin, y down. `radius`: of a rectangle's corners. */
export function formPath(context: CanvasRenderingContext2D, form: Form, insetMm: number, radius: number): void {
  const [width, height] = [form.sizeMm.x - 2 * insetMm, form.sizeMm.y - 2 * insetMm].map((mm) => Math.max(1, mm)) as [number, number]; // prettier-ignore
  context.beginPath();
  if (form.corners) linesPath(context, polygonPath(form, insetMm));
  else if (form.round === true) context.ellipse(0, 0, width / 2, height / 2, 0, 0, 2 * Math.PI);
  else context.roundRect(-width / 2, -height / 2, width, height, radius);
}

/** Adds a closed line through places to a path. */
export function linesPath(context: CanvasRenderingContext2D, outline: Outline): void {
  outline.forEach(({ x, y }, index) => (index === 0 ? context.moveTo(x, y) : context.lineTo(x, y)));
  context.closePath();
}

/** Where a sign has room in a form, y down, and how far it is across there. mm. */
export interface Room {
  readonly at: Vec;
  readonly acrossMm: number;
}

/** Places that are tried along each side of a polygon. Chosen: near enough to the best by eye. */
const TRIED = 16;

/** The place in a form with the most room around it: of a rectangle and an ellipse the middle. */
export function roomIn(form: Form): Room {
  const { sizeMm, corners } = form;
  if (!corners) return { at: { x: 0, y: 0 }, acrossMm: Math.min(sizeMm.x, sizeMm.y) };
  return roomInPolygon(corners, form);
}

const roomInPolygon = lastMadeOf(
  (_: readonly Point[], form: Form): Room => {
    const { sizeMm } = form;
    const outline = polygonPath(form);
    let room: Room = { at: { x: 0, y: 0 }, acrossMm: 0 };
    for (let i = 0; i < TRIED * TRIED; i++) {
      const [column, row] = [i % TRIED, Math.floor(i / TRIED)];
      const at = { x: ((column + 0.5) / TRIED - 0.5) * sizeMm.x, y: ((row + 0.5) / TRIED - 0.5) * sizeMm.y };
      const acrossMm = outlineHolds(outline, at, 0) ? 2 * distanceToEdge(outline, at) : 0;
      if (acrossMm > room.acrossMm) room = { at, acrossMm };
    }
    return room;
  },
  ({ sizeMm: one }, { sizeMm: other }) => one.x === other.x && one.y === other.y,
);

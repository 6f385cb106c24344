import type { Point, Wall } from '#scene/scene';
import type { Palette } from '../../model/palette';
import { toPx, type View } from '../../view/view-transform';

/** How high a course of bricks is at least, in mm; walls of 10 mm have two of them. */
const COURSE_MM = 5;

/** Ratio of a brick's length to its height. */
const BRICK = 3.4;

/** A place where ends of walls meet. */
export interface WallJoint {
  readonly at: Point;
  /** Of the thinnest wall there, mm. */
  readonly thickness: number;
}

/** The places where ends of walls meet: a disc there closes the notch that their straight ends leave. */
export function wallJoints(walls: readonly Wall[]): readonly WallJoint[] {
  const ends = new Map<string, { at: Point; thickness: number; count: number }>();
  for (const { from, to, thickness } of walls)
    for (const at of [from, to]) {
      const key = at.join();
      const there = ends.get(key) ?? { at, thickness, count: 0 };
      there.count += 1;
      there.thickness = Math.min(there.thickness, thickness);
      ends.set(key, there);
    }
  return [...ends.values()].filter(({ count }) => count > 1);
}

/**
 * Draws walls: first their shadows, so that none falls on a neighbour, then the bricks.
 *
 * @param all the walls that these may meet
 */
export function drawWalls(
  context: CanvasRenderingContext2D,
  view: View,
  walls: readonly Wall[],
  palette: Palette,
  all: readonly Wall[] = walls,
): void {
  const lift = Math.min(3, Math.max(1, 2.4 * view.pxPerMm));
  context.fillStyle = 'rgba(0, 0, 0, 0.2)';
  for (const wall of walls) {
    inFrameOf(context, view, wall, { x: lift * 0.6, y: lift }, (length) => {
      context.fillRect(0, -wall.thickness / 2, length, wall.thickness);
    });
  }
  drawJoints(context, view, all, palette);
  for (const wall of walls)
    inFrameOf(context, view, wall, { x: 0, y: 0 }, (length) => drawBricks(context, view, wall, length, palette));
}

function drawJoints(context: CanvasRenderingContext2D, view: View, walls: readonly Wall[], palette: Palette): void {
  context.fillStyle = palette.wall;
  context.beginPath();
  for (const { at, thickness } of wallJoints(walls)) {
    const { x, y } = toPx(view, { x: at[0], y: at[1] });
    const radius = (thickness / 2) * view.pxPerMm;
    context.moveTo(x + radius, y);
    context.arc(x, y, radius, 0, 2 * Math.PI);
  }
  context.fill();
}

/** Calls `paint` with the wall's length in mm, in a frame in mm that starts at its one end and runs along it. */
function inFrameOf(
  context: CanvasRenderingContext2D,
  view: View,
  wall: Wall,
  shiftPx: { x: number; y: number },
  paint: (lengthMm: number) => void,
): void {
  const from = toPx(view, { x: wall.from[0], y: wall.from[1] });
  const dx = wall.to[0] - wall.from[0];
  const dy = wall.to[1] - wall.from[1];
  context.save();
  context.translate(from.x + shiftPx.x, from.y + shiftPx.y);
  context.rotate(Math.atan2(-dy, dx));
  context.scale(view.pxPerMm, view.pxPerMm);
  paint(Math.hypot(dx, dy));
  context.restore();
}

function drawBricks(
  context: CanvasRenderingContext2D,
  view: View,
  wall: Wall,
  lengthMm: number,
  palette: Palette,
): void {
  const thickness = wall.thickness;
  const px = 1 / view.pxPerMm;
  const rounding = Math.min(1.6, thickness / 4);
  context.fillStyle = palette.wall;
  context.beginPath();
  context.roundRect(0, -thickness / 2, lengthMm, thickness, rounding);
  context.fill();
  const courses = Math.max(2, Math.round(thickness / COURSE_MM / Math.max(1, thickness / 60)));
  const height = thickness / courses;
  if (height < 2.4 * px) return;
  context.save();
  context.clip();
  const length = height * BRICK;
  context.fillStyle = palette.wallLight;
  eachBrick(courses, lengthMm, length, (course, x, number) => {
    if (isLight(course, number)) context.fillRect(x, -thickness / 2 + course * height, length, height);
  });
  context.strokeStyle = palette.wallInk;
  context.lineWidth = Math.max(0.16 * height, 0.7 * px);
  context.beginPath();
  for (let course = 1; course < courses; course += 1) {
    const y = -thickness / 2 + course * height;
    context.moveTo(0, y);
    context.lineTo(lengthMm, y);
  }
  eachBrick(courses, lengthMm, length, (course, x) => {
    const y = -thickness / 2 + course * height;
    if (x <= 0) return;
    context.moveTo(x, y);
    context.lineTo(x, y + height);
  });
  context.stroke();
  context.restore();
}

function eachBrick(
  courses: number,
  lengthMm: number,
  brickMm: number,
  visit: (course: number, xMm: number, number: number) => void,
): void {
  for (let course = 0; course < courses; course += 1) {
    const start = course % 2 === 0 ? 0 : -brickMm / 2;
    for (let i = 0; start + i * brickMm < lengthMm; i += 1) visit(course, start + i * brickMm, i);
  }
}

/** About every third brick is lighter: scattered without a visible pattern, and the same at every zoom. */
function isLight(course: number, brick: number): boolean {
  const mixed = Math.imul(course * 374_761 + brick * 668_265 + 1_442_695, 0x9e3779b1);
  return ((mixed ^ (mixed >>> 15)) >>> 0) % 3 === 0;
}

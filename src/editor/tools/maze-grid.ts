import type { Vec } from '#core/geometry';
import { sceneLimits, type Point, type Scene, type Wall } from '#scene/scene';
import { toPoint } from '../plane';

/** An edge between two cells of a maze: the piece `cell` of the grid line `line` that runs along an axis. */
export interface GridEdge {
  readonly along: 'x' | 'y';
  readonly line: number;
  readonly cell: number;
}

/** A stretch along an axis in mm, `from` smaller than `to`. */
export interface Span {
  readonly from: number;
  readonly to: number;
}

/** A name for an edge, the same for the same edge. */
export const keyOf = ({ along, line, cell }: GridEdge): string => `${along}${line},${cell}`;

/** A name for the grid line of an edge. */
export const lineKeyOf = ({ along, line }: GridEdge): string => `${along}${line}`;

/** Edges shorter than this, at the arena's far sides where a cell is cut off, do not count. */
const SHORTEST_MM = 10;

/** The stretch of an edge along its line, cut off at the arena's edge. */
export function spanOf({ along, cell }: GridEdge, cellMm: number, size: Point): Span {
  const length = along === 'x' ? size[0] : size[1];
  return { from: cell * cellMm, to: Math.min((cell + 1) * cellMm, length) };
}

/** An edge inside the arena (not on its rim, which is a wall already), or `null`. */
function existing(edge: GridEdge, cellMm: number, size: Point): GridEdge | null {
  const across = edge.along === 'x' ? size[1] : size[0];
  const { from, to } = spanOf(edge, cellMm, size);
  const isInside = edge.line >= 1 && edge.line * cellMm < across && edge.cell >= 0;
  return isInside && to - from >= SHORTEST_MM ? edge : null;
}

/** The edge along an axis that is nearest to a place within a distance, or `null`. */
export function edgeAlong(
  along: 'x' | 'y',
  place: Vec,
  cellMm: number,
  size: Point,
  withinMm: number,
): GridEdge | null {
  const { edge, awayMm } = beside(along, place, cellMm);
  return awayMm <= withinMm ? existing(edge, cellMm, size) : null;
}

/** The piece of the nearest grid line along an axis, whether or not there is an edge, and its distance. */
function beside(along: 'x' | 'y', { x, y }: Vec, cellMm: number): { readonly edge: GridEdge; readonly awayMm: number } {
  const [on, across] = along === 'x' ? [x, y] : [y, x];
  const line = Math.round(across / cellMm);
  return { edge: { along, line, cell: Math.floor(on / cellMm) }, awayMm: Math.abs(across - line * cellMm) };
}

/** The edge nearest to a place within a distance; `null` if there is none, or if the rim is nearer. */
export function nearestEdge(place: Vec, cellMm: number, size: Point, withinMm: number): GridEdge | null {
  const level = beside('x', place, cellMm);
  const upright = beside('y', place, cellMm);
  const { edge, awayMm } = level.awayMm <= upright.awayMm ? level : upright;
  return awayMm <= withinMm ? existing(edge, cellMm, size) : null;
}

/** The two ends of an edge, world mm. */
export function endsOf(edge: GridEdge, cellMm: number, size: Point): readonly [Vec, Vec] {
  const { from, to } = spanOf(edge, cellMm, size);
  const across = edge.line * cellMm;
  return edge.along === 'x'
    ? [
        { x: from, y: across },
        { x: to, y: across },
      ]
    : [
        { x: across, y: from },
        { x: across, y: to },
      ];
}

/** A wall that lies on a grid line. */
export interface LineWall extends Span {
  readonly wall: Wall;
}

/** A wall this far beside a grid line still counts as on it, in mm. Chosen: it looks straight. */
const ON_LINE_MM = 3;

/** The walls on a grid line in the order of the course. */
export function wallsOn(scene: Scene, { along, line }: GridEdge, cellMm: number): readonly LineWall[] {
  const [on, across] = along === 'x' ? ([0, 1] as const) : ([1, 0] as const);
  const at = line * cellMm;
  const walls: LineWall[] = [];
  for (const wall of scene.objects) {
    if (wall.type !== 'wall') continue;
    if (Math.abs(wall.from[across] - at) > ON_LINE_MM || Math.abs(wall.to[across] - at) > ON_LINE_MM) continue;
    walls.push({ wall, from: Math.min(wall.from[on], wall.to[on]), to: Math.max(wall.from[on], wall.to[on]) });
  }
  return walls;
}

/** The share of an edge that counts as taken by a wall. Chosen: more than a gap that a robot could go through. */
const TAKEN = 0.6;

/** True if walls cover most of an edge. */
export function isTaken({ from, to }: Span, walls: readonly Span[]): boolean {
  const covered = walls.reduce((sum, wall) => sum + Math.max(0, Math.min(to, wall.to) - Math.max(from, wall.from)), 0);
  return covered >= TAKEN * (to - from);
}

/** The ends of a wall along a grid line: `at` is its place across the axis. */
export function wallEndsAlong({ along }: GridEdge, at: number, { from, to }: Span): { from: Point; to: Point } {
  return along === 'x'
    ? { from: toPoint({ x: from, y: at }), to: toPoint({ x: to, y: at }) }
    : { from: toPoint({ x: at, y: from }), to: toPoint({ x: at, y: to }) };
}

/** Half a wall's thickness in whole mm: walls extend this far beyond their edge, so that corners are closed. */
export const overhangMm = (thickness: number): number =>
  Math.floor(Math.min(thickness, sceneLimits.thicknessMm.max) / 2);

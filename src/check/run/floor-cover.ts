import type { Pose } from '#core/geometry';
import { solidParts } from '#scene/kinds/index';
import { isZone, zoneHolds } from '#scene/kinds/zone';
import { boundsOfOutline, type Outline } from '#scene/outline';
import type { Scene } from '#scene/scene';
import { outlineHolds } from '#scene/shape/shape';
import { isMovable } from '#simulation/kinds';

/** Side of a square of floor in mm; larger in an arena that would have more squares than `MOST_CELLS`. Chosen. */
const CELL_MM = 10;
const MOST_CELLS = 250_000;

/** A robot that has moved or turned by less since the last look covers nothing new. Chosen: half a square; 3°. */
const [MOVED_MM, TURNED_RAD] = [5, 0.05];

/** Counts the squares of the floor over which a robot has been. */
export class FloorCover {
  private readonly cellMm: number;
  private readonly columns: number;
  private readonly rows: number;
  /** 0: counts, and is not covered; 1: covered; 2: does not count. */
  private readonly cells: Uint8Array;
  private readonly of: number;
  private covered = 0;
  private last: Pose | null = null;

  /** @param zone id of the zone whose floor counts; `null`: all floor that is free of walls and of what stands fast */
  constructor(course: Scene, zone: string | null) {
    const [width, height] = course.size;
    this.cellMm = Math.max(CELL_MM, Math.ceil(Math.sqrt((width * height) / MOST_CELLS)));
    this.columns = Math.ceil(width / this.cellMm);
    this.rows = Math.ceil(height / this.cellMm);
    this.cells = new Uint8Array(this.columns * this.rows);
    const within = course.objects.filter(isZone).find(({ id }) => id === zone);
    if (zone !== null)
      for (let cell = 0; cell < this.cells.length; cell += 1)
        if (within === undefined || !zoneHolds(within, this.middleOf(cell))) this.cells[cell] = 2;
    const solids = course.objects.filter((object) => object.type !== 'mover' && !isMovable(object)).flatMap(solidParts);
    for (const part of solids) this.eachWithin(part, (cell) => (this.cells[cell] = 2));
    this.of = this.cells.reduce((sum, state) => (state === 0 ? sum + 1 : sum), 0);
  }

  /** Share of the floor that is covered, in per cent. */
  get percent(): number {
    return this.of === 0 ? 0 : (100 * this.covered) / this.of;
  }

  /** The robot is here now. @param body asked for only if it has moved */
  visit(pose: Pose, body: () => readonly Outline[]): void {
    if (this.last !== null && isNear(this.last, pose)) return;
    this.last = pose;
    for (const part of body())
      this.eachWithin(part, (cell) => {
        if (this.cells[cell] !== 0) return;
        this.cells[cell] = 1;
        this.covered += 1;
      });
  }

  /** Calls for each square whose middle lies within an outline. */
  private eachWithin(outline: Outline, call: (cell: number) => void): void {
    const { minX, minY, maxX, maxY } = boundsOfOutline(outline);
    const { cellMm, columns, rows } = this;
    const last = (end: number, most: number): number => Math.min(most - 1, Math.floor(end / cellMm));
    for (let row = Math.max(0, Math.floor(minY / cellMm)); row <= last(maxY, rows); row += 1)
      for (let column = Math.max(0, Math.floor(minX / cellMm)); column <= last(maxX, columns); column += 1) {
        const cell = row * columns + column;
        if (outlineHolds(outline, this.middleOf(cell), 0)) call(cell);
      }
  }

  private middleOf(cell: number): { readonly x: number; readonly y: number } {
    const column = cell % this.columns;
    return { x: (column + 0.5) * this.cellMm, y: ((cell - column) / this.columns + 0.5) * this.cellMm };
  }
}

const isNear = (one: Pose, other: Pose): boolean =>
  Math.abs(one.xMm - other.xMm) < MOVED_MM &&
  Math.abs(one.yMm - other.yMm) < MOVED_MM &&
  Math.abs(one.headingRad - other.headingRad) < TURNED_RAD;

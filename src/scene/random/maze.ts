import { createRng, type Rng } from '#core/rng';
import { sceneDefaults, type Point, type Scene, type SceneObject, type Wall } from '../scene';

/** The request for a random maze. */
export interface MazeWish {
  /** A whole number; the same seed and size always give the same maze. */
  readonly seed: number;
  readonly columns: number;
  readonly rows: number;
  /** Side of a cell in mm: `mazeLimits.cellMm`. */
  readonly cellMm: number;
}

/** Limits of mazes. Chosen: the smallest has a path with bends, the largest fits the largest arena. */
export const mazeLimits = {
  cells: { min: 2, max: 30 },
  /** 200: the robots just turn round in it; 300: with room to spare. */
  cellMm: { min: 200, max: 300 },
} as const;

/** A cell, counted from the lower left corner. */
interface Cell {
  readonly column: number;
  readonly row: number;
}

/** Which cells are open to each other: `right[i]` to the cell at the right, `up[i]` to the one above. */
interface Passages {
  readonly right: boolean[];
  readonly up: boolean[];
}

const LINE_MM = 30; // chosen: wide enough that no robot steps over it between two looks
const STEPS = [
  { column: 1, row: 0, headingDeg: 0 },
  { column: 0, row: 1, headingDeg: 90 },
  { column: -1, row: 0, headingDeg: 180 },
  { column: 0, row: -1, headingDeg: 270 },
] as const;

/**
 * A perfect maze as a course: between any two cells there is exactly one path. The robot starts in the lower left cell
 * and looks into the open; the target is the cell that is farthest from it, with a black line across for the line
 * sensors. The arena's edge is the outer wall.
 *
 * @param words name and description of the course
 * @throws RangeError for sizes beyond `mazeLimits`
 */
export function randomMaze(wish: MazeWish, words: Pick<Scene, 'name' | 'description'>): Scene {
  checkWish(wish);
  const passages = dig(wish, createRng(wish.seed).fork('maze'));
  const start: Cell = { column: 0, row: 0 };
  const { cell: end, headingDeg: arrival } = farthestFrom(start, wish, passages);
  const headingDeg = STEPS.find((step) => isOpen(start, step, wish, passages))?.headingDeg ?? 0;
  return {
    ...words,
    size: [wish.columns * wish.cellMm, wish.rows * wish.cellMm],
    board: null,
    robot: { type: null, at: centreOf(start, wish), heading: headingDeg, scale: 1, options: {} },
    task: sceneDefaults.task,
    background: null,
    objects: [...finish(end, arrival, wish), ...walls(wish, passages)],
  };
}

function checkWish({ columns, rows, cellMm }: MazeWish): void {
  const { cells, cellMm: cell } = mazeLimits;
  const isCount = (count: number): boolean => Number.isInteger(count) && count >= cells.min && count <= cells.max;
  if (!isCount(columns) || !isCount(rows))
    throw new RangeError(`A maze has ${String(cells.min)} to ${String(cells.max)} cells a side, not ${String(columns)} × ${String(rows)}.`); // prettier-ignore
  if (!Number.isInteger(cellMm) || cellMm < cell.min || cellMm > cell.max)
    throw new RangeError(`A cell is ${String(cell.min)} to ${String(cell.max)} mm wide, not ${String(cellMm)}.`);
}

const indexOf = ({ column, row }: Cell, { columns }: MazeWish): number => row * columns + column;

const isInside = ({ column, row }: Cell, { columns, rows }: MazeWish): boolean =>
  column >= 0 && row >= 0 && column < columns && row < rows;

const neighbour = (cell: Cell, step: Cell): Cell => ({ column: cell.column + step.column, row: cell.row + step.row });

/** The passage between a cell and the one a step away is kept with the left or lower of the two. */
function passageOf(cell: Cell, step: Cell, wish: MazeWish, { right, up }: Passages) {
  const first = step.column + step.row > 0 ? cell : neighbour(cell, step);
  return { list: step.row === 0 ? right : up, index: indexOf(first, wish) };
}

function isOpen(cell: Cell, step: Cell, wish: MazeWish, passages: Passages): boolean {
  if (!isInside(neighbour(cell, step), wish)) return false;
  const { list, index } = passageOf(cell, step, wish, passages);
  return list[index] === true;
}

/** Digs from cell to cell at random, and back where all around is dug (depth-first search): long ways with many bends. */
function dig(wish: MazeWish, rng: Rng): Passages {
  const count = wish.columns * wish.rows;
  const passages: Passages = {
    right: Array.from({ length: count }, () => false),
    up: Array.from({ length: count }, () => false),
  };
  const first: Cell = { column: Math.floor(rng.unit() * wish.columns), row: Math.floor(rng.unit() * wish.rows) };
  const dug = new Set([indexOf(first, wish)]);
  const way = [first];
  for (let cell = way.at(-1); cell !== undefined; cell = way.at(-1)) {
    const here = cell;
    const free = STEPS.filter((step) => {
      const next = neighbour(here, step);
      return isInside(next, wish) && !dug.has(indexOf(next, wish));
    });
    const step = free[Math.floor(rng.unit() * free.length)];
    if (step === undefined) {
      way.pop();
      continue;
    }
    const { list, index } = passageOf(here, step, wish, passages);
    list[index] = true;
    const next = neighbour(here, step);
    dug.add(indexOf(next, wish));
    way.push(next);
  }
  return passages;
}

/** The cell with the longest path from `start`, and the robot's heading when it comes in. */
function farthestFrom(start: Cell, wish: MazeWish, passages: Passages): { cell: Cell; headingDeg: number } {
  const seen = new Set([indexOf(start, wish)]);
  const queue: { cell: Cell; headingDeg: number }[] = [{ cell: start, headingDeg: 0 }];
  let last = { cell: start, headingDeg: 0 };
  for (let head = 0; head < queue.length; head += 1) {
    last = queue[head] ?? last;
    for (const step of STEPS) {
      const next = neighbour(last.cell, step);
      if (!isOpen(last.cell, step, wish, passages) || seen.has(indexOf(next, wish))) continue;
      seen.add(indexOf(next, wish));
      queue.push({ cell: next, headingDeg: step.headingDeg });
    }
  }
  return last;
}

const centreOf = ({ column, row }: Cell, { cellMm }: MazeWish): Point => [
  Math.round((column + 0.5) * cellMm),
  Math.round((row + 0.5) * cellMm),
];

/** The target, which fills its cell except for a rim, and a black line through its middle, across the way in. */
function finish(cell: Cell, headingDeg: number, wish: MazeWish): SceneObject[] {
  const at = centreOf(cell, wish);
  const side = wish.cellMm - 40; // chosen: the walls stay clear of it
  const half = Math.round(wish.cellMm / 2) - LINE_MM;
  const [dx, dy] = headingDeg % 180 === 0 ? [0, half] : [half, 0];
  const points: Point[] = [
    [at[0] - dx, at[1] - dy],
    [at[0] + dx, at[1] + dy],
  ];
  return [
    { type: 'target', id: 'target', at, size: [side, side], angle: 0, round: false, number: 0, blocks: 0 },
    { type: 'stroke', id: 'finish', points, width: LINE_MM, color: 'black' },
  ];
}

/** A wall for each closed edge between two cells; those in a row are one. */
function walls(wish: MazeWish, { right, up }: Passages): Wall[] {
  const { columns, rows, cellMm } = wish;
  const level = runs(rows - 1, columns, (line, along) => up[line * columns + along] !== true);
  const upright = runs(columns - 1, rows, (line, along) => right[along * columns + line] !== true);
  const ends = [
    ...level.map(({ line, from, to }): [Point, Point] => [
      [from * cellMm, (line + 1) * cellMm],
      [to * cellMm, (line + 1) * cellMm],
    ]),
    ...upright.map(({ line, from, to }): [Point, Point] => [
      [(line + 1) * cellMm, from * cellMm],
      [(line + 1) * cellMm, to * cellMm],
    ]),
  ];
  const thickness = sceneDefaults.thickness;
  return ends.map(([from, to], index) => ({ type: 'wall', id: `wall-${String(index + 1)}`, from, to, thickness }));
}

/** Stretches of closed edges on each grid line, from one crossing to another. */
function runs(lines: number, length: number, isClosed: (line: number, along: number) => boolean) {
  const found: { line: number; from: number; to: number }[] = [];
  for (let line = 0; line < lines; line += 1) {
    let from: number | null = null;
    for (let along = 0; along <= length; along += 1) {
      const closed = along < length && isClosed(line, along);
      if (closed) from ??= along;
      else if (from !== null) {
        found.push({ line, from, to: along });
        from = null;
      }
    }
  }
  return found;
}

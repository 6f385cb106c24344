import { FULL_BRIGHTNESS } from './raster';

/** Cells by their brightness, row by row from the upper left. */
export interface Cells {
  readonly columns: number;
  readonly rows: number;
  /** 0 … `FULL_BRIGHTNESS` each. */
  readonly brightness: Uint16Array;
}

/** Patches along the longer side. Chosen: wider than any line, and narrow enough for the shadow of a hand. */
const PATCHES = 10;
/** How many of a patch's cells may be brighter than its paper: noise, and the rim of a reflection. */
const BRIGHTER = 0.1;
/** Paper in the shade is at least this bright, as a share of the brightest: anything darker is meant to be dark. */
const DARKEST_PAPER = 0.35;

/**
 * The same cells as if the light were even: in each patch of the floor its paper is found, the brightest that is not
 * noise, and everything is seen relative to that. A lamp at one side and the photographer's shadow disappear; a line
 * stays as dark as it is beside its paper.
 */
export function evened({ columns, rows, brightness }: Cells): Cells {
  const side = Math.max(1, Math.ceil(Math.max(columns, rows) / PATCHES));
  const across = Math.ceil(columns / side);
  const down = Math.ceil(rows / side);
  const paper = withNeighbours(paperOf({ columns, rows, brightness }, side, across, down), across, down);
  const out = new Uint16Array(brightness.length);
  for (let row = 0; row < rows; row += 1)
    for (let column = 0; column < columns; column += 1) {
      const white = between(paper, across, down, (column + 0.5) / side - 0.5, (row + 0.5) / side - 0.5);
      const seen = ((brightness[row * columns + column] ?? 0) * FULL_BRIGHTNESS) / white;
      out[row * columns + column] = Math.min(FULL_BRIGHTNESS, Math.round(seen));
    }
  return { columns, rows, brightness: out };
}

/** The brightness of the paper in each patch. */
function paperOf(cells: Cells, side: number, across: number, down: number): number[] {
  const brightest = nearlyBrightest(cells.brightness);
  return Array.from({ length: across * down }, (_, patch) => {
    const [left, top] = [(patch % across) * side, Math.floor(patch / across) * side];
    const inside: number[] = [];
    for (let row = top; row < Math.min(cells.rows, top + side); row += 1)
      for (let column = left; column < Math.min(cells.columns, left + side); column += 1)
        inside.push(cells.brightness[row * cells.columns + column] ?? 0);
    return Math.max(1, DARKEST_PAPER * brightest, nearlyBrightest(inside));
  });
}

/** The brightness that all but the few brightest stay below. */
function nearlyBrightest(values: ArrayLike<number>): number {
  const sorted = Uint16Array.from(values).sort();
  return sorted[Math.floor((sorted.length - 1) * (1 - BRIGHTER))] ?? 0;
}

/** Each patch at least as bright as half of those around it: one that is all line has its paper beside it. */
function withNeighbours(paper: readonly number[], across: number, down: number): number[] {
  return paper.map((own, patch) => {
    const [x, y] = [patch % across, Math.floor(patch / across)];
    const around: number[] = [];
    for (let row = Math.max(0, y - 1); row <= Math.min(down - 1, y + 1); row += 1)
      for (let column = Math.max(0, x - 1); column <= Math.min(across - 1, x + 1); column += 1)
        around.push(paper[row * across + column] ?? 0);
    around.sort((one, other) => one - other);
    return Math.max(own, around[around.length >> 1] ?? 0);
  });
}

/** The paper at a place between the middles of four patches. */
function between(paper: readonly number[], across: number, down: number, x: number, y: number): number {
  const [left, top] = [hold(Math.floor(x), across), hold(Math.floor(y), down)];
  const [right, bottom] = [hold(Math.floor(x) + 1, across), hold(Math.floor(y) + 1, down)];
  const [partX, partY] = [x - Math.floor(x), y - Math.floor(y)];
  const at = (column: number, row: number): number => paper[row * across + column] ?? 1;
  const above = at(left, top) * (1 - partX) + at(right, top) * partX;
  const below = at(left, bottom) * (1 - partX) + at(right, bottom) * partX;
  return above * (1 - partY) + below * partY;
}

const hold = (at: number, count: number): number => Math.min(count - 1, Math.max(0, at));

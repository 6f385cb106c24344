/** The results of a camera from its picture: blocks of colours, and the line that leads away from the robot. */
import { HUSKYLENS_PICTURE, type HuskyArrow, type HuskyBlock } from '#devices/huskylens';
import type { CameraCell, SeenTag } from '#world/probes/camera';

const { width: WIDTH, height: HEIGHT } = HUSKYLENS_PICTURE;

/** A colour in fewer cells is too small to be told: chosen. */
const LEAST_CELLS = 6;
/** Darker than that in one of red, green and blue, the floor is a line. */
const DARK = 0.6;
/** Ink wider than this share of the picture is a crossing, or a field, and no line. */
const WIDEST = 0.5;
/** A line may be interrupted for so many rows, and wander so far aside from one row to the next (share of the picture). */
const GAP_ROWS = 4;
const ASIDE = 0.05;
/** Rows that a line needs. */
const LEAST_ROWS = 3;

type Rows = readonly (readonly CameraCell[])[];

/** The tags of a picture as blocks: the boxes around them. */
export const tagBlocks = (tags: readonly SeenTag[]): readonly HuskyBlock[] =>
  tags.map(({ number, corners }) => {
    const xs = corners.map(({ x }) => x * WIDTH);
    const ys = corners.map(({ y }) => y * HEIGHT);
    return boxOf([Math.min(...xs), Math.max(...xs)], [Math.min(...ys), Math.max(...ys)], number);
  });

const boxOf = (
  [left, right]: readonly [number, number],
  [top, bottom]: readonly [number, number],
  id: number,
): HuskyBlock => ({
  ...{ kind: 'block', x: Math.round((left + right) / 2), y: Math.round((top + bottom) / 2) },
  ...{ width: Math.round(right - left), height: Math.round(bottom - top), id },
});

/**
 * The connected cells of one colour as blocks, the largest first.
 *
 * @param colourOf number of a colour from 1 on; 0: it is none
 */
export function colourBlocks(rows: Rows, colourOf: (cell: CameraCell) => number): readonly HuskyBlock[] {
  const columns = rows[0]?.length ?? 0;
  const left = rows.flatMap((row) => row.map(colourOf));
  const found: { readonly block: HuskyBlock; readonly cells: number }[] = [];
  for (let start = 0; start < left.length; start++) {
    const id = left[start] ?? 0;
    if (id === 0) continue;
    const places = takeConnected(left, start, columns);
    if (places.length < LEAST_CELLS) continue;
    const xs = places.map((place) => place % columns);
    const ys = places.map((place) => Math.floor(place / columns));
    const across = (column: number): number => (column * WIDTH) / columns;
    const down = (row: number): number => (row * HEIGHT) / rows.length;
    const block = boxOf(
      [across(Math.min(...xs)), across(Math.max(...xs) + 1)],
      [down(Math.min(...ys)), down(Math.max(...ys) + 1)],
      id,
    );
    found.push({ block, cells: places.length });
  }
  return found.sort((a, b) => b.cells - a.cells).map(({ block }) => block);
}

/** The places of one colour that hang together with `start`; they are taken out of the list. */
function takeConnected(left: number[], start: number, columns: number): readonly number[] {
  const id = left[start];
  const places: number[] = [start];
  left[start] = 0;
  for (const place of places) {
    const column = place % columns;
    const beside = [
      ...(column > 0 ? [place - 1] : []),
      ...(column < columns - 1 ? [place + 1] : []),
      ...[place - columns, place + columns],
    ];
    for (const next of beside) {
      if (left[next] !== id) continue;
      left[next] = 0;
      places.push(next);
    }
  }
  return places;
}

/** Ink in a row, in shares of the picture. */
interface Ink {
  readonly from: number;
  readonly to: number;
}
const middleOf = ({ from, to }: Ink): number => (from + to) / 2;

/**
 * The line that begins nearest to the middle below, from near to far; `null`: there is none.
 *
 * @param heights the middles of the rows in the picture, in px
 */
export function lineArrow(rows: Rows, heights: readonly number[]): HuskyArrow | null {
  let last: Ink | null = null;
  let gap = 0;
  const way: { readonly x: number; readonly y: number }[] = [];
  for (let row = rows.length - 1; row >= 0; row--) {
    const inks = inksOf(rows[row] ?? []);
    const reach = ASIDE * (1 + gap);
    const near = last;
    const touched =
      near === null ? inks : inks.filter(({ from, to }) => from <= near.to + reach && to >= near.from - reach);
    const lines = touched.filter(({ from, to }) => to - from <= WIDEST);
    const next = nearest(lines, near === null ? 0.5 : middleOf(near));
    if (next !== null) {
      last = next;
      gap = 0;
      way.push({ x: Math.round(middleOf(next) * WIDTH), y: Math.round(heights[row] ?? 0) });
    } else if (last !== null && touched.length === 0 && ++gap > GAP_ROWS) break;
  }
  const [tail, head] = [way[0], way[way.length - 1]];
  if (tail === undefined || head === undefined || way.length < LEAST_ROWS) return null;
  return { kind: 'arrow', tail: [tail.x, tail.y], head: [head.x, head.y], id: 1 };
}

/** The dark parts of the floor in a row. */
function inksOf(row: readonly CameraCell[]): readonly Ink[] {
  const inks: Ink[] = [];
  let from = -1;
  for (let column = 0; column <= row.length; column++) {
    const isDark = isInk(row[column]);
    if (isDark && from < 0) from = column;
    if (!isDark && from >= 0) {
      inks.push({ from: from / row.length, to: column / row.length });
      from = -1;
    }
  }
  return inks;
}

const isInk = (cell: CameraCell | undefined): boolean =>
  cell !== undefined && cell.isFloor && cell.shares !== null && Math.min(...cell.shares) < DARK;

const nearest = (inks: readonly Ink[], to: number): Ink | null =>
  inks.reduce<Ink | null>(
    (best, ink) => (best === null || Math.abs(middleOf(ink) - to) < Math.abs(middleOf(best) - to) ? ink : best),
    null,
  );

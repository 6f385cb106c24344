import { radOf } from '#core/angle';
import { exactCos, exactSin } from '#core/exact-math';
import type { Vec } from '#core/geometry';
import { TILE_MM } from '#scene/league/league';
import { EXIT, type MapTile } from './map';
import { BOTTOM, LEFT, opposite, turned, type Side } from './side';

/** The lines and marks of a tile before it is turned: mm from its middle, x to the right, y up. */
export interface TileShape {
  /** Middle lines of black lines, cut where there are gaps. */
  readonly lines: readonly (readonly Vec[])[];
  /** Middles of green marks. */
  readonly marks: readonly Vec[];
  /** False if the editor's picture shows another line, which leads from and to the same sides. */
  readonly isAsDrawn: boolean;
}

/** Half the side of a tile. */
export const HALF_MM = TILE_MM / 2;

/** Width of the line. */
export const LINE_MM = 20;

/** From both middle lines to the middle of a green mark of 25 mm: it lies beside the line. */
const MARK_MM = 22.5;

/** The black parts of straight tiles with gaps, from the left, 0 … 300 mm, by the editor's picture. */
const cuts: Readonly<Record<string, readonly (readonly [number, number])[]>> = {
  'tile-11': [
    [0, 50],
    [100, 200],
    [250, 300],
  ],
  'tile-11_2': [
    [0, 50],
    [100, 300],
  ],
  'tile-20': [
    [0, 50],
    [250, 300],
  ],
  'tile-49': [
    [0, 92],
    [204, 300],
  ],
};

/** A gap in a straight tile that we do not know: 100 mm in its middle. */
const USUAL_CUT: readonly (readonly [number, number])[] = [
  [0, 100],
  [200, 300],
];

/** Pictures that look as they are drawn here. */
const known = new Set(
  ['0', '12', '15', '16', '16_2', '19', '30', '31', '32', '33', '34', '35']
    .map((number) => `tile-${number}`)
    .concat(EXIT, ...Object.keys(cuts)),
);

/** The shape of a tile, by its picture if we know it, else by its ways. */
export function shapeOf(tile: MapTile): TileShape {
  const { image, paths, gaps, crossings } = tile;
  const isAsDrawn = known.has(image);
  if (image === EXIT) return { lines: [[edge(BOTTOM), { x: 0, y: -LINE_MM / 2 }]], marks: [], isAsDrawn };
  if (image === 'tile-21') return plain([[edge(LEFT), { x: 0, y: 0 }, edge(BOTTOM)]]);
  if (image === 'tile-22') return plain([[edge(LEFT), edge(BOTTOM)]]);
  const sides = new Set([...paths.keys(), ...paths.values()]);
  const isCrossing = sides.size > 2 && (crossings > 0 || !isPaired(paths));
  if (isCrossing)
    return { lines: [...sides].map((side) => [edge(side), { x: 0, y: 0 }]), marks: marksOf(paths, sides), isAsDrawn };
  const cut = (Object.hasOwn(cuts, image) ? cuts[image] : undefined) ?? (gaps > 0 ? USUAL_CUT : null);
  return { lines: pairsOf(paths).flatMap(([from, to]) => lineBetween(from, to, cut)), marks: [], isAsDrawn };
}

const plain = (lines: TileShape['lines']): TileShape => ({ lines, marks: [], isAsDrawn: true });

/** The middle of a side. */
const edge = (side: Side): Vec =>
  ({ 0: { x: 0, y: HALF_MM }, 1: { x: HALF_MM, y: 0 }, 2: { x: 0, y: -HALF_MM }, 3: { x: -HALF_MM, y: 0 } })[side];

/** True if every way can be driven in both directions: there are only lines beside each other. */
const isPaired = (paths: MapTile['paths']): boolean =>
  [...paths].every(([from, to]) => paths.get(to) === from && from !== to);

/** The pairs of sides that lines connect; a way out and back is one. */
function pairsOf(paths: MapTile['paths']): readonly (readonly [Side, Side])[] {
  const pairs: (readonly [Side, Side])[] = [];
  for (const [from, to] of paths)
    if (from !== to && !pairs.some((pair) => pair.includes(from) && pair.includes(to))) pairs.push([from, to]);
  return pairs;
}

/** A straight line, with its gaps, or a quarter of a circle. */
function lineBetween(from: Side, to: Side, cut: readonly (readonly [number, number])[] | null): TileShape['lines'] {
  if (to !== opposite(from)) return [arcBetween(from, to)];
  const [start, end] = [edge(from), edge(to)].sort((one, other) => one.x - other.x || other.y - one.y);
  if (start === undefined || end === undefined) return [];
  const at = (mm: number): Vec => ({
    x: start.x + ((end.x - start.x) * mm) / TILE_MM,
    y: start.y + ((end.y - start.y) * mm) / TILE_MM,
  });
  // A line has round ends: beside a gap it begins half its width later.
  const round = LINE_MM / 2;
  return (cut ?? [[0, TILE_MM] as const]).map(([first, last]) => [
    at(first === 0 ? 0 : first + round),
    at(last === TILE_MM ? TILE_MM : last - round),
  ]);
}

/** Pieces of a quarter. Chosen: less than half a mm from the circle. */
const PIECES = 12;

function arcBetween(from: Side, to: Side): readonly Vec[] {
  const [start, end] = [edge(from), edge(to)];
  return Array.from({ length: PIECES + 1 }, (_, index) => {
    const angle = radOf((90 * index) / PIECES);
    // About the corner between both sides: from one edge's middle to the other's.
    const [towards, away] = [1 - exactSin(angle), 1 - exactCos(angle)];
    return { x: start.x * towards + end.x * away, y: start.y * towards + end.y * away };
  });
}

/**
 * The marks of a crossing. A mark lies in the quarter between two arms; for a robot on one of them it is on the left
 * before the crossing, for one on the other on the right. It is there if it turns either of them.
 */
function marksOf(paths: MapTile['paths'], sides: ReadonlySet<Side>): readonly Vec[] {
  const turns = (entry: Side, side: Side): boolean => {
    const exit = paths.get(entry);
    return exit === side || exit === entry;
  };
  return ([0, 1, 2, 3] as const).flatMap((side): readonly Vec[] => {
    const next = turned(side, 1);
    const isMarked = (sides.has(side) && turns(side, next)) || (sides.has(next) && turns(next, side));
    const [one, other] = [edge(side), edge(next)];
    const scale = MARK_MM / HALF_MM;
    return isMarked ? [{ x: (one.x + other.x) * scale, y: (one.y + other.y) * scale }] : [];
  });
}

/** A place on a tile that lies turned clockwise. */
export function turnedPlace({ x, y }: Vec, quarters: number): Vec {
  const places = [
    { x, y },
    { x: y, y: -x },
    { x: -x, y: -y },
    { x: -y, y: x },
  ];
  return places[((quarters % 4) + 4) % 4] ?? { x, y };
}

/** A place on the way from a side to another one, `share` of it along; both as the tile lies. From its middle, y up. */
export function placeOnWay(entry: Side, exit: Side, share: number): Vec {
  if (exit === entry) return { x: 0, y: 0 };
  const [start, end] = [edge(entry), edge(exit)];
  if (exit === opposite(entry))
    return { x: start.x + (end.x - start.x) * share, y: start.y + (end.y - start.y) * share };
  const points = arcBetween(entry, exit);
  return points[Math.round(share * PIECES)] ?? end;
}

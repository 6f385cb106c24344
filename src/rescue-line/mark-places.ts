import { radOf } from '#core/angle';
import { exactCos, exactSin } from '#core/exact-math';
import type { Vec } from '#core/geometry';
import type { League } from '#scene/league/league';
import type { PointLine } from './points';

/** A mark on a tile: the number of a checkpoint, or points. */
export interface LeagueMark {
  readonly key: string;
  readonly kind: 'checkpoint' | PointLine['state'];
  readonly text: string;
  /** In world mm. */
  readonly at: Vec;
}

/** From the middle of a tile to a mark on it: beside the line, within the tile. */
const ASIDE_MM = 95;
const BEHIND_MM = 80;

/** The marks of a scored line: checkpoints on the left of the way, points on its right; the points of a tile are one mark. */
export function markPlaces({ tiles }: League, lines: readonly PointLine[]): readonly LeagueMark[] {
  const checkpoints = tiles.flatMap(({ checkpoint }, index) => (checkpoint && index > 0 ? [index] : []));
  const places = [...new Set(lines.filter(({ points }) => points > 0).map(({ tile }) => tile))];
  return [
    ...checkpoints.map((tile, index) => ({
      ...{ key: `checkpoint ${String(tile)}`, kind: 'checkpoint', text: String(index + 1), at: beside(tiles, tile, 1) } as const,
    })),
    ...places.map((tile) => {
      const here = lines.filter((line) => line.tile === tile && line.points > 0);
      const isOpen = here.some(({ state }) => state === 'open');
      const kind = isOpen ? 'open' : here.some(({ state }) => state === 'earned') ? 'earned' : 'missed';
      const sum = here.reduce((so, { points }) => so + points, 0);
      return { key: `points ${String(tile)}`, kind, text: String(sum), at: beside(tiles, tile, -1) } as const;
    }),
  ];
} // prettier-ignore

/** A place beside the line of a tile. @param side 1: on the left, in a bend in its outer corner; −1: on the other side */
function beside(tiles: League['tiles'], index: number, side: 1 | -1): Vec {
  const tile = tiles[index];
  const [x, y] = tile?.at ?? [0, 0];
  const out = directionOf(tile?.heading ?? 0);
  const into = directionOf((tiles[index - 1] ?? tile)?.heading ?? 0);
  const isBend = out.x * into.x + out.y * into.y === 0;
  const away = isBend ? { x: into.x - out.x, y: into.y - out.y } : { x: -out.y, y: out.x };
  // On the last tile behind the strip across its middle.
  const behind = index === tiles.length - 1 ? BEHIND_MM : 0;
  return { x: x + side * ASIDE_MM * away.x + behind * out.x, y: y + side * ASIDE_MM * away.y + behind * out.y };
}

const directionOf = (deg: number): Vec => ({
  x: Math.round(exactCos(radOf(deg))) + 0,
  y: Math.round(exactSin(radOf(deg))) + 0,
});
